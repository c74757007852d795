/** Takes of a shot's camera, of its blocking and of its scene's layout: keep, choose, drop, compare. */

import { LitElement, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { Edit, PanelCard, ShotDetails, Take } from "./messages";
import "./takes_compare";
import type { TakesCompare } from "./takes_compare";
import type { Wire } from "./wire";

export type TakesOf = "camera" | "blocking" | "layout";

/** The takes that a shot has of something. */
export function takesOf(details: ShotDetails, of: TakesOf): Take[] {
  return of === "camera" ? details.takes : details[`${of}_takes`];
}

const WHAT = { camera: "Camera", blocking: "Blocking", layout: "Layout of the scene" };

@customElement("sb-takes")
export class Takes extends LitElement {
  @property({ attribute: false }) details!: ShotDetails;
  @property({ attribute: false }) card!: PanelCard;
  @property({ attribute: false }) aspect = 16 / 9;
  @property({ attribute: false }) wire!: Wire;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  private edit(of: TakesOf, action: string, number?: number): void {
    const edit: Edit = { kind: "take", shot: this.details.shot, of, action, ...(number ? { number } : {}) };
    this.dispatchEvent(new CustomEvent("edit", { detail: edit }));
  }

  render() {
    return (Object.keys(WHAT) as TakesOf[]).map((of) => this.row(of));
  }

  private row(of: TakesOf) {
    const takes = takesOf(this.details, of);
    const locked = this.details.locked.includes(of === "layout" ? "layout of the scene" : of);
    return html`<div class="takes" role="group" aria-label="Takes: ${WHAT[of]}"><span class="soft">${WHAT[of]}</span>
      ${takes.length > 1 ? takes.map((take) => this.take(of, take, locked)) : nothing}
      <button ?disabled=${locked} title="The next edits make another take; this one stays" @click=${() => this.edit(of, "keep")}>Keep, and try another</button>
      ${takes.length > 1
        ? html`<button @click=${() => this.querySelector<TakesCompare>(`sb-compare[data-of=${of}]`)!.open()}>Compare</button>
            <sb-compare data-of=${of} .of=${of} .details=${this.details} .card=${this.card} .aspect=${this.aspect} .wire=${this.wire}
              @edit=${(event: CustomEvent<Edit>) => this.dispatchEvent(new CustomEvent("edit", { detail: event.detail }))}></sb-compare>`
        : nothing}</div>`;
  }

  private take(of: TakesOf, take: Take, locked: boolean) {
    const words = [take.camera, ...take.decided].filter(Boolean).join(", ") || "as the crew made it";
    return html`<span><button class=${take.in_film ? "chosen" : ""} aria-pressed=${take.in_film} title=${words} ?disabled=${take.in_film || locked}
        @click=${() => this.edit(of, "choose", take.number)}>Take ${take.number}</button>${take.in_film
          ? nothing
          : html`<button class="quiet" title="Drop take ${take.number}" aria-label="Drop take ${take.number} of the ${of}" @click=${() => this.edit(of, "drop", take.number)}>×</button>`}</span>`;
  }
}
