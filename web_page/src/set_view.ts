/** Set and light of a scene: what it is made of, its hour and weather, and every lamp. */

import { LitElement, html, nothing, type PropertyValues } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { live } from "lit/directives/live.js";
import { hex, linear } from "./colors";
import type { Board, Edit, LampValue, SceneDetails } from "./messages";
import "./picture_choice";
import type { Wire } from "./wire";

@customElement("sb-set")
export class SetView extends LitElement {
  @property({ attribute: false }) board!: Board;
  @property({ attribute: false }) selected: string[] = [];
  @property({ attribute: false }) wire!: Wire;
  @state() private scene = "";
  @state() private details: SceneDetails | null = null;
  @state() private failed = "";

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  protected willUpdate(changed: PropertyValues<this>): void {
    if (changed.has("selected") && this.selected.length) this.scene = this.selected[0].slice(0, -6);
    this.scene ||= this.board.scenes[0].scene;
    if (changed.has("board") || changed.has("selected") || this.details?.scene !== this.scene) void this.ask();
  }

  private async ask(): Promise<void> {
    const scene = this.scene;
    try {
      const details = await this.wire.call<SceneDetails>("scene", { scene });
      if (scene === this.scene) [this.details, this.failed] = [details, ""];
    } catch (error) {
      this.failed = (error as Error).message;
    }
  }

  private edit(edit: Edit): void {
    this.dispatchEvent(new CustomEvent("edit", { detail: [edit] }));
  }

  private set(decision: Record<string, unknown>): void {
    this.edit({ kind: "set", scene: this.scene, decision });
  }

  private light(decision: Record<string, unknown>): void {
    this.edit({ kind: "light", scene: this.scene, decision });
  }

  private choose(scene: string): void {
    this.scene = scene;
    this.dispatchEvent(new CustomEvent("select", { detail: [] }));
    void this.ask();
  }

  render() {
    const details = this.details?.scene === this.scene ? this.details : null;
    return html`<section class="setlight" aria-label="Set and light">
      <label>Scene <select @change=${(event: Event) => this.choose(value(event))}>
        ${this.board.scenes.map((scene) => html`<option value=${scene.scene} ?selected=${scene.scene === this.scene}>${scene.scene} ${scene.title}</option>`)}
      </select></label>
      ${this.failed ? html`<p class="wrong" role="alert">${this.failed}</p>` : nothing}
      ${details ? html`${this.pictures(details)}<div class="columns">${this.place(details)}${this.lighting(details)}</div>${this.lamps(details)}` : html`<p>...</p>`}
    </section>`;
  }

  /** The scene's first shots, which follow what is changed. */
  private pictures(details: SceneDetails) {
    const cards = this.board.scenes.flatMap((scene) => scene.shots).filter((card) => details.shots.includes(card.shot));
    return html`<div class="strip">${cards.map((card) => html`<figure class=${card.state}>
      ${card.picture ? html`<img src=${card.picture} alt=${card.words || card.shot} />` : nothing}<figcaption>${card.shot}</figcaption></figure>`)}</div>`;
  }

  private place(details: SceneDetails) {
    const locked = details.locked.includes("set");
    return html`<fieldset ?disabled=${locked}><legend>Set</legend>
      <label>Kit <select data-field="kit" @change=${(event: Event) => this.set({ kit: value(event) })}>
        ${details.kits.map((kit) => html`<option value=${kit.key} ?selected=${kit.key === details.kit}>${kit.name}</option>`)}</select></label>
      ${(["walls", "ground"] as const).map((part) => details[part] === null ? nothing : html`<label>${part === "walls" ? "Walls" : "Floor or ground"}
        <select data-field=${part} @change=${(event: Event) => value(event) && this.set({ [part]: value(event) })}>
          <option value="" ?selected=${!details[part]}>as the kit has it</option>
          ${details.materials.map((name) => html`<option value=${name} ?selected=${name === details[part]}>${name.replaceAll("_", " ")}</option>`)}
        </select></label>${this.surface(details, part)}`)}
      ${this.words("Furnished", "period", details.words.period, details.period, (period) => this.set({ period }))}
      ${Object.entries(details.options).map(([name, on]) => html`<label><input type="checkbox" .checked=${on}
        @change=${() => this.set({ options: { [name]: !on } })} /> ${name.replaceAll("_", " ")}</label>`)}
      <label><input type="checkbox" .checked=${details.snow} @change=${() => this.set({ snow: !details.snow })} /> snow on the ground</label>
      ${details.decided.map((said) => html`<p class="decided">You decided ${said}</p>`)}
    </fieldset>`;
  }

  private lighting(details: SceneDetails) {
    return html`<fieldset ?disabled=${details.locked.includes("light")}><legend>Light</legend>
      ${this.words("Hour", "time_of_day", details.words.time_of_day, details.time_of_day, (time_of_day) => this.light({ time_of_day }))}
      ${this.words("Weather", "weather", details.words.weather, details.weather, (weather) => this.light({ weather }))}
      ${this.slider("Warmth", "warmth", details.warmth, 3)}${this.slider("Brightness", "brightness", details.brightness, 3)}
      ${this.slider("Contrast", "contrast", details.contrast, 2)}
      ${this.words("Faces lit from", "key_side", ["left", "right"], details.key_side, (key_side) => this.light({ key_side }))}
      <div role="group" aria-label="Character of the light">${details.words.qualities.map((name) => {
        const has = details.qualities.includes(name);
        const qualities = has ? details.qualities.filter((each) => each !== name) : [...details.qualities, name];
        return html`<label><input type="checkbox" .checked=${has} @change=${() => this.light({ qualities })} /> ${name}</label>`;
      })}</div>
      ${details.outdoors ? this.panorama(details) : nothing}
    </fieldset>`;
  }

  /** The panorama that lights an exterior by day, or the drawn sky. */
  private panorama(details: SceneDetails) {
    return html`<sb-pictures .wire=${this.wire} kind="panorama" label="Panorama" .now=${details.panorama} without="the drawn sky"
      @chose=${(event: CustomEvent<object | null>) => this.lightBy(event.detail)}></sb-pictures>
      ${details.panorama_rests ? html`<p class="told">It lights the scene from morning to afternoon; now the hour is ${details.time_of_day}.</p>` : nothing}`;
  }

  private lightBy(picture: object | null): void {
    if (picture) this.dispatchEvent(new CustomEvent("panorama", { detail: { scene: this.scene, ...picture } }));
    else this.light({ panorama: "none" });
  }

  /** The picture of a surface that walls or ground are made of, in place of a finish. */
  private surface(details: SceneDetails, part: "walls" | "ground") {
    if (details[part] === null) return nothing;
    const chosen = ({ detail }: CustomEvent<object | null>) =>
      detail
        ? this.dispatchEvent(new CustomEvent("surface", { detail: { scene: this.scene, part, ...detail } }))
        : this.set({ [part === "walls" ? "wall_texture" : "ground_texture"]: "none" });
    return html`<sb-pictures .wire=${this.wire} kind="texture" data-part=${part} label=${part === "walls" ? "Picture of the walls" : "Picture of the floor or ground"}
      .now=${details.surfaces[part] ?? ""} without="the finish" @chose=${chosen}></sb-pictures>${this.repeat(details, part)}`;
  }

  /** How wide the picture of a surface is laid, until it repeats. */
  private repeat(details: SceneDetails, part: "walls" | "ground") {
    const metres = details.repeats[part];
    if (metres === undefined) return nothing;
    const changed = (input: HTMLInputElement) => {
      const detail = { scene: this.scene, part, metres: Number(input.value) };
      if (input.checkValidity() && input.value) this.dispatchEvent(new CustomEvent("surface", { detail }));
      else input.reportValidity();
    };
    return html`<label>It repeats every <input type="number" data-field="repeat-${part}" min="0.01" max="25" step="any" .value=${live(String(metres))}
      @change=${(event: Event) => changed(event.target as HTMLInputElement)} /> m</label>`;
  }

  private words(label: string, field: string, words: string[], now: string, chosen: (word: string) => void) {
    return html`<label>${label} <select data-field=${field} @change=${(event: Event) => value(event) && chosen(value(event))}>
      ${words.includes(now) ? nothing : html`<option value="" selected>the crew's choice</option>`}
      ${words.map((word) => html`<option ?selected=${word === now}>${word}</option>`)}</select></label>`;
  }

  private slider(label: string, field: string, now: number, most: number) {
    return html`<label>${label} <input type="range" data-field=${field} min=${-most} max=${most} step="0.25" .value=${String(now)}
      @change=${(event: Event) => this.light({ [field]: Number(value(event)) })} /> <output>${now > 0 ? "+" : ""}${now}</output></label>`;
  }

  private lamps(details: SceneDetails) {
    return html`<h2>Lamps</h2><table class="lamps"><thead><tr><th>Lamp</th><th>Kind</th><th>Power</th><th>Colour</th><td></td></tr></thead><tbody>
      ${details.lamps.map((lamp) => this.lamp(lamp, details.locked.includes("light")))}</tbody></table>`;
  }

  private lamp(lamp: LampValue, locked: boolean) {
    const change = (decided: object | null) => this.light({ lamps: { [lamp.name]: decided } });
    return html`<tr data-lamp=${lamp.name}><td>${lamp.name.replaceAll("_", " ")}</td><td>${lamp.kind.toLowerCase()}</td>
      <td><input type="number" min="0" max="100000" step="any" aria-label="Power of ${lamp.name}" ?disabled=${locked} .value=${live(String(lamp.power))}
        @change=${(event: Event) => change({ power: Number(value(event)) })} /> ${lamp.kind === "SUN" ? "W/m²" : "W"}</td>
      <td><input type="color" aria-label="Colour of ${lamp.name}" ?disabled=${locked} .value=${hex(lamp.color)}
        @change=${(event: Event) => change({ color: linear(value(event)) })} /></td>
      <td><button ?disabled=${locked} @click=${() => change(null)} aria-label="Take ${lamp.name} away">Take away</button></td></tr>`;
  }
}

function value(event: Event): string {
  return (event.target as HTMLInputElement).value;
}
