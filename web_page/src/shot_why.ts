/** Why a shot is as it is: who decided what, and the script's lines with the words that the rules read marked. */

import { LitElement, html, nothing, type PropertyValues } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { ShotReasons, WordsRead } from "./messages";
import type { Wire } from "./wire";

@customElement("sb-why")
export class ShotWhy extends LitElement {
  @property({ attribute: false }) shot = "";
  /** Of the project; reasons are asked for anew when it changes. */
  @property({ attribute: false }) revision = "";
  @property({ attribute: false }) wire!: Wire;
  @state() private reasons: ShotReasons | null = null;
  @state() private failed = "";
  @state() private open = false;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  protected willUpdate(changed: PropertyValues<this>): void {
    if (changed.has("shot") || changed.has("revision")) {
      this.reasons = null;
      if (this.open) void this.ask();
    }
  }

  private toggle(event: Event): void {
    this.open = (event.target as HTMLDetailsElement).open;
    if (this.open && !this.reasons) void this.ask();
  }

  private async ask(): Promise<void> {
    this.failed = "";
    try {
      const reasons = await this.wire.call<ShotReasons>("why", { shot: this.shot });
      if (reasons.shot === this.shot) this.reasons = reasons;
    } catch (error) {
      this.failed = (error as Error).message;
    }
  }

  render() {
    return html`<details class="why" @toggle=${(event: Event) => this.toggle(event)}>
      <summary>Why is it like this?</summary>
      ${this.failed ? html`<p class="wrong">${this.failed}</p>` : this.reasons ? this.told(this.reasons) : html`<p>...</p>`}
    </details>`;
  }

  private told(reasons: ShotReasons) {
    return html`
      ${reasons.decided.length ? html`<p class="decided">You decided ${reasons.decided.join("; ")}</p>` : nothing}
      <table><thead><tr><th>Role</th><th>By</th><th>Score</th><th>Turns</th></tr></thead><tbody>
        ${reasons.roles.map(
          (role) => html`<tr><td>${role.role.replaceAll("_", " ")}${role.subject === reasons.shot ? "" : ` (${role.subject})`}</td>
            <td>${role.by}</td><td>${role.score === null ? "" : role.score.toFixed(1)}</td><td>${role.turns}</td></tr>
            ${[...role.remarks, ...role.warnings, ...role.fixes.map((fix) => `mended: ${fix}`)].map(
              (said) => html`<tr class="said"><td colspan="4">${said}</td></tr>`,
            )}`,
        )}
      </tbody></table>
      ${reasons.lines.map((line, number) => html`<p>${marked(line, reasons.words.filter((word) => word.line === number))}</p>`)}
      ${reasons.words.length
        ? html`<ul>${reasons.words.map(
            (word) => html`<li>“${reasons.lines[word.line].slice(word.start, word.end)}”: ${word.kind} ${word.what} <small>${word.rule}</small></li>`,
          )}</ul>`
        : nothing}`;
  }
}

/** A line with what was read in it marked; what lies in one another is marked once. */
function marked(line: string, words: WordsRead[]) {
  const parts = [];
  let at = 0;
  for (const word of [...words].sort((a, b) => a.start - b.start || a.end - b.end)) {
    if (word.start < at) continue;
    const there = words.filter((each) => each.start >= word.start && each.end <= word.end);
    const title = there.map((each) => `${each.kind} ${each.what}`).join("; ");
    parts.push(line.slice(at, word.start), html`<mark title=${title}>${line.slice(word.start, word.end)}</mark>`);
    at = word.end;
  }
  return [...parts, line.slice(at)];
}
