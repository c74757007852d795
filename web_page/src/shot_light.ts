/** The mood of the light in a shot, which is that of its scene: hour, character, warmer or cooler, brighter or darker. */

import { LitElement, html, nothing, type PropertyValues } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { Edit, SceneDetails } from "./messages";
import type { Wire } from "./wire";

const STEP = 0.5;

@customElement("sb-light")
export class ShotLight extends LitElement {
  @property({ attribute: false }) scene = "";
  @property({ attribute: false }) revision = "";
  @property({ attribute: false }) wire!: Wire;
  @state() private details: SceneDetails | null = null;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  protected willUpdate(changed: PropertyValues<this>): void {
    if (changed.has("scene") || changed.has("revision")) void this.ask();
  }

  private async ask(): Promise<void> {
    const details = await this.wire.call<SceneDetails>("scene", { scene: this.scene }).catch(() => null);
    if (details?.scene === this.scene) this.details = details;
  }

  private decide(decision: object): void {
    const edit: Edit = { kind: "light", scene: this.scene, decision };
    this.dispatchEvent(new CustomEvent("edit", { detail: edit }));
  }

  render() {
    const details = this.details;
    if (!details) return nothing;
    const chosen = (event: Event) => (event.target as HTMLSelectElement).value;
    const now = details.qualities.join(", ");
    return html`<fieldset ?disabled=${details.locked.includes("light")}><legend>Light of ${details.scene}</legend>
      <label>Hour <select @change=${(event: Event) => this.decide({ time_of_day: chosen(event) })}>
        ${details.words.time_of_day.map((hour) => html`<option ?selected=${hour === details.time_of_day}>${hour}</option>`)}</select></label>
      <label>Mood <select @change=${(event: Event) => this.decide({ qualities: [chosen(event)] })}>
        ${details.qualities.length === 1 ? nothing : html`<option selected disabled>${now || "even"}</option>`}
        ${details.words.qualities.map((mood) => html`<option ?selected=${mood === now}>${mood}</option>`)}</select></label>
      ${this.steps("warmth", details.warmth, "Cooler", "Warmer")}${this.steps("brightness", details.brightness, "Darker", "Brighter")}
    </fieldset>`;
  }

  private steps(field: "warmth" | "brightness", now: number, less: string, more: string) {
    const to = (value: number) => this.decide({ [field]: value });
    return html`<span class="steps"><button ?disabled=${now <= -3} @click=${() => to(now - STEP)}>${less}</button>
      <button ?disabled=${now >= 3} @click=${() => to(now + STEP)}>${more}</button></span>`;
  }
}
