/** What was saved in Blender: what is understood, what the project has otherwise, and what is kept in a copy. */

import { LitElement, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { PullConflict, Pulled } from "./messages";
import type { Wire } from "./wire";

type Side = "blender" | "project";

@customElement("sb-pull")
export class PullView extends LitElement {
  @property({ attribute: false }) wire!: Wire;
  @state() private found: Pulled | null = null;
  @state() private chosen: Record<string, Side> = {};
  @state() private failed = "";

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  protected firstUpdated(): void {
    void this.look();
  }

  private async look(): Promise<void> {
    try {
      this.found = await this.wire.call<Pulled>("changes");
    } catch (error) {
      this.failed = (error as Error).message;
    }
  }

  private takeOver(): void {
    const take = Object.keys(this.chosen).filter((id) => this.chosen[id] === "blender");
    const leave = Object.keys(this.chosen).filter((id) => this.chosen[id] === "project");
    this.dispatchEvent(new CustomEvent("take-over", { detail: { take, leave } }));
  }

  render() {
    return html`<section class="pull" aria-label="Saved in Blender">
      <h2>Saved in Blender</h2>
      ${this.failed ? html`<p class="wrong" role="alert">${this.failed}</p>` : nothing}
      ${this.found ? this.listed(this.found) : this.failed ? nothing : html`<p role="status">Reading the file ...</p>`}
    </section>`;
  }

  private listed(found: Pulled) {
    const nothingThere = !found.files.length && !found.conflicts.length;
    if (nothingThere) return html`<p>story.blend is as it was written.</p>`;
    const changed = found.understood.length + found.conflicts.length + found.kept.length;
    return html`
      ${changed ? nothing : html`<p>The file was saved, and nothing in it was changed.</p>`}
      ${this.sentences("Will be taken over", found.understood)}
      ${found.conflicts.length
        ? html`<h3>Changed here as well: which stands?</h3>${found.conflicts.map((conflict) => this.conflict(conflict))}`
        : nothing}
      ${this.sentences("Not taken over; a copy of the file with the date in its name keeps it", found.kept)}
      <p class="buttons"><button class="primary" @click=${() => this.takeOver()}>Take over</button>
        Undo takes it back. What you do not choose waits here, and the project stands.</p>`;
  }

  private sentences(title: string, sentences: string[]) {
    return sentences.length ? html`<h3>${title}</h3><ul>${sentences.map((each) => html`<li>${each}</li>`)}</ul>` : nothing;
  }

  private conflict(conflict: PullConflict) {
    const choice = (side: Side, label: string, words: string) =>
      html`<button class=${this.chosen[conflict.id] === side ? "chosen" : ""} aria-pressed=${this.chosen[conflict.id] === side}
        @click=${() => (this.chosen = { ...this.chosen, [conflict.id]: side })}><b>${label}</b> ${words}</button>`;
    const values = conflict.compiled && conflict.saved ? ` (${conflict.compiled}, now ${conflict.saved})` : "";
    return html`<div class="conflict" role="group" aria-label=${conflict.id}>
      ${choice("blender", "Blender", conflict.words + values)} ${choice("project", "Project", conflict.project.join("; "))}
    </div>`;
  }
}
