/** The crew at work: stages with progress, and what each role proposed, how it scored, what was mended and who took over. */

import { LitElement, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { worksOf, type Work } from "./crew_work";
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
/** Stages of which the page tells no more than that another one goes on. */
const WITHIN: Record<string, string> = { prints: "deliver", encode: "motion", story: "deliver" };
const WORKS_SHOWN = 80;

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
    const stage = WITHIN[status.stage] ?? status.stage;
    const stages = Object.entries(STAGES).filter(([name]) => name !== "motion" || status.film);
    const at = stages.findIndex(([name]) => name === stage);
    const shots = (this.board?.scenes ?? []).flatMap((scene) => scene.shots).filter((shot) => shot.picture);
    return html`
      <section class="crew" aria-label="The crew at work">
        <div class="head"><h2>${status.work}</h2>${status.busy
          ? html`<button @click=${() => this.dispatchEvent(new Event("stop"))}>Stop</button>`
          : html`<span class="buttons"><button @click=${() => this.dispatchEvent(new Event("go-on"))}>Go on</button>
              <button @click=${() => this.dispatchEvent(new Event("back"))}>Back</button></span>`}</div>
        ${status.error ? html`<p class="bar wrong" role="alert">${status.error}</p>` : nothing}
        <ol class="stages">${stages.map(([name, words], index) => html`
          <li class=${index < at ? "done" : index === at ? "now" : ""} aria-current=${index === at ? "step" : nothing}>${words}
            ${index === at && status.busy ? this.progress(status, words) : nothing}</li>`)}
        </ol>
        <div class="halves">
          <div class="log" tabindex="0" role="log" aria-label="What the crew does">${this.works()}</div>
          <div class="grid" aria-label="Frames" role="group">${shots.length
            ? shots.map((shot) => html`<figure><img src=${shot.picture} alt=${shot.words || shot.shot} /><figcaption>${shot.shot}</figcaption></figure>`)
            : html`<p class="soft">The frames appear here as they are drawn.</p>`}</div>
        </div>
      </section>
    `;
  }

  private progress(status: Status, words: string) {
    return html`<progress max=${status.total || nothing} value=${status.total ? status.step : nothing} aria-label=${words}></progress>
      ${status.total > 1 ? html`<span class="soft">${status.step} of ${status.total}</span>` : nothing}`;
  }

  private works() {
    const works = worksOf(this.events);
    const first = Math.max(0, works.length - WORKS_SHOWN);
    const shown = works.slice(first).map((work, index) => [first + index, work] as const).reverse();
    return shown.length ? repeat(shown, ([number]) => number, ([, work]) => this.work(work)) : html`<p class="soft">The crew gathers.</p>`;
  }

  private work(work: Work) {
    const role = work.role.replaceAll("_", " ");
    const list = (kind: string, words: string[]) => words.map((each) => html`<li class=${kind}>${each}</li>`);
    return html`<div class="event ${work.done ? "" : "now"}">
      <span class="role">${role}</span> <b>${work.subject}</b>
      ${work.scores.length ? html`<span class="score" title="What its critic gives, of 10">${work.scores.map((score) => score.toFixed(1)).join(" → ")}</span>` : nothing}
      ${work.handed ? html`<span class="warn">handed over</span>` : nothing}
      <ul>${list("minded", work.remarks)}${list("mended", work.fixes)}${list("warn", work.warnings)}</ul>
      ${work.proposal ? html`<details><summary>What it proposes</summary><code>${work.proposal}</code></details>` : nothing}
    </div>`;
  }
}
