/** The lines of a shot: its words, and when each speech begins and how long it is. */

import { LitElement, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { Edit, LineTime, ShotDetails } from "./messages";

@customElement("sb-lines")
export class ShotLines extends LitElement {
  @property({ attribute: false }) details!: ShotDetails;
  @property({ attribute: false }) cast: Record<string, string> = {};

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  private decide(time: LineTime, decided: object | null): void {
    const marks = { lines: { [time.line]: decided } };
    const edit: Edit = { kind: "blocking", shot: this.details.shot, person: time.person, marks };
    this.dispatchEvent(new CustomEvent("edit", { detail: edit }));
  }

  private field(label: string, now: number, least: number, changed: (value: number) => void) {
    return html`<label>${label} <input type="number" step="0.1" min=${least} max="600" .value=${String(now)}
      @change=${(event: Event) => {
        const field = event.target as HTMLInputElement;
        if (field.value && field.checkValidity()) changed(Number(field.value));
        else field.value = String(now);
      }} /> s</label>`;
  }

  render() {
    return html`<h3>Script</h3>
      ${this.details.lines.map((line, index) => {
        const time = this.details.speech.find((each) => each.line === index + 1);
        return html`<p class=${line.kind === "dialogue" ? "speech" : ""}>
            ${line.speaker ? html`<b>${this.cast[line.speaker] ?? line.speaker}</b> ` : nothing}${line.text}</p>
          ${time ? this.timing(time) : nothing}`;
      })}`;
  }

  private timing(time: LineTime) {
    return html`<div class="timing" role="group" aria-label="When line ${time.line} is said">
      ${this.field("from", time.at, 0, (at) => this.decide(time, { at }))}
      ${this.field("for", time.seconds, 0.3, (seconds) => this.decide(time, { seconds }))}
      ${time.decided ? html`<button class="quiet" @click=${() => this.decide(time, null)}>As the crew has it</button>` : nothing}</div>`;
  }
}
