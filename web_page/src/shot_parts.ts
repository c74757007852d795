/** The shot in the cut: split it, join it with the next one, add a shot after it; what of it is locked. */

import { LitElement, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { Board, Edit, ShotDetails } from "./messages";

const KINDS = ["insert", "reaction", "single", "two_shot", "establishing"];
const PARTS = ["camera", "blocking", "duration"];

@customElement("sb-parts")
export class ShotParts extends LitElement {
  @property({ attribute: false }) board!: Board;
  @property({ attribute: false }) details!: ShotDetails;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  private edit(edit: Edit): void {
    this.dispatchEvent(new CustomEvent("edit", { detail: edit }));
  }

  /** The shot that follows in its scene; none after the last. */
  private get next(): string {
    const shots = this.board.scenes.find((scene) => this.details.shot.startsWith(scene.scene))!.shots.filter((card) => !card.omitted);
    return shots[shots.findIndex((card) => card.shot === this.details.shot) + 1]?.shot ?? "";
  }

  render() {
    return html`
      <details><summary>Split, join, add a shot</summary>${this.split()}${this.join()}${this.add()}</details>
      <div class="locks" role="group" aria-label="Locked">Locked: ${PARTS.map((part) => {
        const locked = this.details.locked.includes(part);
        return html`<label><input type="checkbox" .checked=${locked} ?disabled=${this.details.approved}
          @change=${() => this.edit({ kind: locked ? "unlock" : "lock", target: this.details.shot, parts: [part] })} /> ${part}</label>`;
      })}</div>`;
  }

  private split() {
    const { shot, lines, seconds } = this.details;
    const { shortest, first, last, lines: places } = this.details.split;
    const timed = first <= last;
    if (!timed && !places.length)
      return html`<p class="soft">Too short to split: neither part is to be shorter than ${shortest} s, as the crew plans shots.</p>`;
    const half = Math.min(Math.max(Math.round(seconds * 5) / 10, first), last);
    return html`<form @submit=${(event: SubmitEvent) => this.send(event, (at) => {
        const place = String(at.get("line")) ? { line: Number(at.get("line")) } : { seconds: Number(at.get("seconds")) };
        return { kind: "split", shot, ...place };
      })}>
      ${places.length
        ? html`<label>Split at <select name="line">${timed ? html`<option value="">a time</option>` : nothing}
            ${places.map((number) => html`<option value=${number}>${lines[number - 1].text.slice(0, 40)}</option>`)}</select></label>`
        : html`<input type="hidden" name="line" value="" />`}
      ${timed
        ? html`<label>Second <input type="number" name="seconds" min=${first} max=${last} step="0.1" .value=${String(half)} /></label>
            <span class="soft">${first} to ${last}</span>`
        : nothing}
      <button>Split</button></form>`;
  }

  private join() {
    const other = this.next;
    return other
      ? html`<p><button @click=${() => this.edit({ kind: "join", shot: this.details.shot, other })}>Join with ${other}</button></p>`
      : nothing;
  }

  private add() {
    const { shot, shows, on_stage } = this.details;
    const subjects = [...new Set([...shows, ...on_stage])];
    return html`<form @submit=${(event: SubmitEvent) => this.send(event, (of) => {
        const on = String(of.get("on"));
        const decision = { kind: of.get("kind"), ...(on ? { focus_on_ids: [on] } : {}) };
        return { kind: "add_shot", shot, decision, seconds: Number(of.get("seconds")) };
      })}>
      <label>Add <select name="kind">${KINDS.map((kind) => html`<option value=${kind}>${kind.replace("_", "-")}</option>`)}</select></label>
      <label>of <select name="on"><option value="">what this shot shows</option>
        ${subjects.map((id) => html`<option value=${id}>${this.board.cast[id] ?? id.replaceAll("_", " ")}</option>`)}</select></label>
      <label>Seconds <input type="number" name="seconds" min="0.2" max="60" step="0.1" value="2" /></label>
      <button>Add after this</button></form>`;
  }

  private send(event: SubmitEvent, edit: (form: FormData) => Edit): void {
    event.preventDefault();
    this.edit(edit(new FormData(event.target as HTMLFormElement)));
  }
}
