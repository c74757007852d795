/** How a person looks: body, hair and clothes, each with its colours. */

import { LitElement, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import { linear } from "./colors";
import type { AssetDetails, Edit, LookChoices, LookNow } from "./messages";

/** Colours that hair grows in, and grey. */
const HAIR = ["#120d0b", "#3a2214", "#5c3a20", "#8a4a22", "#a98a5e", "#d9bf86", "#b9b8b6", "#efeeea"];
const PLACES: Record<string, string> = { upper: "Upper body", lower: "Legs", feet: "Feet", head: "Head", "": "Accessories" };

@customElement("sb-look")
export class AssetLook extends LitElement {
  @property({ attribute: false }) details!: AssetDetails;
  @property({ attribute: false }) look!: LookNow;
  @property({ attribute: false }) choices!: LookChoices;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  private edit(said: Record<string, unknown>): void {
    const edit: Edit = { kind: "look", person: this.details.asset, ...said };
    this.dispatchEvent(new CustomEvent("edit", { detail: [edit] }));
  }

  private decide(decision: Record<string, unknown>): void {
    this.edit({ decision });
  }

  render() {
    const { look } = this;
    return html`<fieldset class="body" ?disabled=${this.details.locked}><legend>Body</legend>
      <label>Age <input type="number" data-field="age" min="0" max="110" step="1" .value=${String(look.age)}
        @change=${(event: Event) => this.number(event, "age")} /></label>
      <label>Height <input type="number" data-field="stature" min="0.4" max="2.4" step="0.01" .value=${look.stature.toFixed(2)}
        @change=${(event: Event) => this.number(event, "stature")} /> m</label>
      ${look.species
        ? html`<p class="told">An animal that acts: ${look.species}</p>`
        : html`${this.choice("Sex", "gender", ["female", "male"], look.gender)}
            ${this.choice("Build", "build", ["slim", "average", "athletic", "stocky", "heavy"], look.build)}
            <div class="swatches" role="group" aria-label="Skin">Skin ${Object.entries(this.choices.skins).map(([tone, color]) => this.swatch(color, tone, tone === look.skin, () => this.decide({ skin: tone })))}</div>
            <button @click=${() => this.decide({ face: (look.face + 1) % 1000 })}>Another face</button>`}
      </fieldset>
      ${look.species ? nothing : this.hair()}${this.clothes()}`;
  }

  private hair() {
    const { look } = this;
    return html`<fieldset ?disabled=${this.details.locked}><legend>Hair</legend>
      <label>Style <select data-field="hair" @change=${(event: Event) => this.decide({ hair: value(event) })}>
        ${Object.entries(this.choices.hair).map(([key, name]) => html`<option value=${key} ?selected=${key === look.hair}>${name}</option>`)}</select></label>
      <div class="swatches" role="group" aria-label="Colour of the hair">
        ${HAIR.map((color) => this.swatch(color, color, color === look.hair_color, () => this.decide({ hair_color: linear(color) })))}
        <input type="color" aria-label="Another colour of the hair" .value=${look.hair_color} @change=${(event: Event) => this.decide({ hair_color: linear(value(event)) })} /></div>
      ${this.choice("Beard", "facial_hair", ["none", "stubble", "moustache", "beard"], look.facial_hair)}
      <label><input type="checkbox" .checked=${look.glasses} @change=${() => this.decide({ glasses: !look.glasses })} /> Glasses</label>
    </fieldset>`;
  }

  private clothes() {
    const { garments } = this.look;
    const worn = new Set(garments.map((each) => each.key));
    return html`<fieldset class="clothes" ?disabled=${this.details.locked}><legend>Clothes and shoes</legend>
      ${garments.map((each) => html`<div class="garment" data-garment=${each.key}>
        <input type="color" aria-label="Colour of the ${each.name}" .value=${each.color}
          @change=${(event: Event) => this.edit({ wear: [{ key: each.key, color: linear(value(event)) }] })} />
        <span>${each.name}</span>
        <span class="swatches">${(this.choices.garments.find((known) => known.key === each.key)?.colors ?? []).map((color) =>
          this.swatch(color, `${each.name} ${color}`, color === each.color, () => this.edit({ wear: [{ key: each.key, color: linear(color) }] })))}</span>
        <button class="quiet" aria-label="Take off the ${each.name}" @click=${() => this.edit({ take_off: [each.key] })}>Take off</button></div>`)}
      <label>Put on <select data-field="wear" @change=${(event: Event) => this.wear(event)}><option value="">choose ...</option>
        ${Object.entries(PLACES).map(([on, label]) => html`<optgroup label=${label}>${this.choices.garments
          .filter((each) => each.on === on && !worn.has(each.key))
          .map((each) => html`<option value=${each.key}>${each.name}</option>`)}</optgroup>`)}</select></label>
    </fieldset>`;
  }

  private wear(event: Event): void {
    const key = value(event);
    if (key) this.edit({ wear: [{ key }] });
    (event.target as HTMLSelectElement).value = "";
  }

  private number(event: Event, field: string): void {
    const input = event.target as HTMLInputElement;
    if (input.value && input.checkValidity()) this.decide({ [field]: Number(input.value) });
  }

  private choice(label: string, field: string, words: string[], now: string) {
    return html`<label>${label} <select data-field=${field} @change=${(event: Event) => this.decide({ [field]: value(event) })}>
      ${words.map((word) => html`<option ?selected=${word === now}>${word}</option>`)}</select></label>`;
  }

  private swatch(color: string, label: string, chosen: boolean, take: () => void) {
    return html`<button class="swatch ${chosen ? "chosen" : ""}" style="background: ${color}" aria-label=${label} aria-pressed=${chosen} title=${label} @click=${take}></button>`;
  }
}

function value(event: Event): string {
  return (event.target as HTMLInputElement).value;
}
