/** The lines of a shot: its words, and when each speech begins and how long it is. */

import { LitElement, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { Edit, LineTime, ShotDetails } from "./messages";
import { numberField } from "./number_field";

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
      ${numberField("from", time.at, (at) => this.decide(time, { at }), 0.1, 0, 600, " s")}
      ${numberField("for", time.seconds, (seconds) => this.decide(time, { seconds }), 0.1, 0.3, 600, " s")}
      ${time.decided ? html`<button class="quiet" @click=${() => this.decide(time, null)}>As the crew has it</button>` : nothing}</div>`;
  }
}
