/** The crew at work: stages with progress, and what each role proposed, how it scored and who took over. */

import { LitElement, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { Board, CrewEvent, Status } from "./messages";

const STAGES: Record<string, string> = {
  ground: "Reading the script",
  materialize: "Casting and props",
  stage: "Sets, staging, motion, light",
  pack: "Packing scenes",
  camera: "Setting the cameras",
  frames: "Drawing the frames",
  motion: "Drawing the film",
  deliver: "Board, lists and Blender file",
};

@customElement("sb-crew")
export class CrewView extends LitElement {
  @property({ attribute: false }) events: CrewEvent[] = [];
  @property({ attribute: false }) status: Status | null = null;
  @property({ attribute: false }) board: Board | null = null;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  render() {
    const status = this.status!;
    const at = Object.keys(STAGES).indexOf(status.stage);
    return html`
      <section class="crew">
        <ol class="stages">${Object.entries(STAGES).map(([stage, words], index) => html`
          <li class=${index < at ? "done" : index === at ? "now" : ""}>${words}
            ${index === at && status.total
              ? html`<progress max=${status.total} value=${status.step} aria-label=${words}></progress>`
              : nothing}</li>`)}
        </ol>
        ${status.error ? html`<p class="bar wrong" role="alert">${status.error}</p>` : nothing}
        <p>${status.busy
            ? html`<button @click=${() => this.dispatchEvent(new Event("stop"))}>Stop</button>`
            : html`<button @click=${() => this.dispatchEvent(new Event("back"))}>Back</button>`}</p>
        <div class="log" tabindex="0" role="log" aria-label="What the crew does">${this.events.filter((event) => event.kind !== "stage")
          .slice(-120).reverse().map((event) => this.line(event))}</div>
        <div class="grid">${(this.board?.scenes ?? []).flatMap((scene) => scene.shots).filter((shot) => shot.picture)
          .map((shot) => html`<img src=${shot.picture} alt=${shot.shot} />`)}</div>
      </section>
    `;
  }

  private line(event: CrewEvent) {
    const role = event.role.replaceAll("_", " ");
    const score = event.score == null ? nothing : html`<b class="score">${event.score.toFixed(1)}</b>`;
    const details = event.details?.length ? html`<ul>${event.details.map((each) => html`<li>${each}</li>`)}</ul>` : nothing;
    return html`<div class="event ${event.kind}"><span class="role">${role}</span> ${event.subject ?? ""}
      <i>${event.kind}${event.turn ? ` (turn ${event.turn})` : ""}</i> ${score} ${event.message ?? ""}${details}</div>`;
  }
}
