/** What a person does from the moment that is shown: one of the user's own clips, or a motion of the catalog, found by words. */

import { LitElement, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";

const MOST = 60;

/** A motion: its key, and what it shows. */
type Motion = [key: string, told: string];

@customElement("sb-motion")
export class StageMotion extends LitElement {
  /** The user's clips: key, and what it shows and where it is from. */
  @property({ attribute: false }) own: Record<string, string> = {};
  /** Those of the catalog. */
  @property({ attribute: false }) motions: Record<string, string> = {};
  @state() private words = "";
  @state() private open = false;
  /** Whether the list ends with the field: there is no room for it on the right. */
  @state() private late = false;
  /** Which of those that are shown Enter takes; none before a word is typed or an arrow pressed. */
  @state() private at = -1;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  protected updated(): void {
    this.querySelector('[aria-selected="true"]')?.scrollIntoView({ block: "nearest" });
  }

  private fitting(motions: Record<string, string>): Motion[] {
    const words = this.words.toLowerCase().split(/[\s_]+/);
    return Object.entries(motions).filter(([key, told]) => words.every((word) => `${key} ${told}`.toLowerCase().includes(word)));
  }

  private look(words: string): void {
    [this.words, this.open] = [words, true];
    this.at = words ? Math.max(0, this.shown.findIndex(([key]) => key === words)) : -1;
    this.late = this.offsetLeft > this.parentElement!.clientWidth / 2;
  }

  private take(key: string): void {
    [this.words, this.open] = ["", false];
    this.dispatchEvent(new CustomEvent("motion", { detail: key }));
  }

  /** What the list has, from top to bottom. */
  private get shown(): Motion[] {
    return [...this.fitting(this.own), ...this.fitting(this.motions).slice(0, MOST)];
  }

  private keys(event: KeyboardEvent): void {
    const shown = this.shown;
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step) [this.at, this.open] = [Math.max(0, Math.min(shown.length - 1, this.at + step)), true];
    else if (event.key === "Enter" && this.open && shown[this.at]) this.take(shown[this.at][0]);
    else if (event.key === "Escape" && this.open) [this.words, this.open] = ["", false];
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  render() {
    const shown = this.shown;
    const own = shown.filter(([key]) => key in this.own);
    const others = shown.slice(own.length);
    return html`<label>Does from here <input role="combobox" aria-expanded=${this.open} aria-controls="motions" aria-autocomplete="list" size="12"
        placeholder="wave ..." autocomplete="off" aria-activedescendant=${this.open && shown[this.at] ? `motion-${this.at}` : nothing} .value=${this.words}
        @focus=${() => this.look("")} @click=${() => (this.open = true)} @blur=${() => (this.open = false)}
        @input=${(event: Event) => this.look((event.target as HTMLInputElement).value)}
        @keydown=${(event: KeyboardEvent) => this.keys(event)} /></label>
      <div id="motions" class="motions ${this.late ? "late" : ""}" role="listbox" aria-label="Motions" ?hidden=${!this.open}>
        ${own.length ? html`<p role="presentation">Your clips</p>` : nothing}${own.map((motion, at) => this.row(motion, at))}
        ${own.length && others.length ? html`<p role="presentation">Motions</p>` : nothing}${others.map((motion, at) => this.row(motion, own.length + at))}
        ${shown.length ? nothing : html`<div role="option" aria-disabled="true" aria-selected="false">Nothing of that; try another word.</div>`}
      </div>`;
  }

  private row([key, told]: Motion, at: number) {
    const pressed = (event: Event) => (event.preventDefault(), this.take(key));
    return html`<div role="option" id="motion-${at}" data-motion=${key} aria-selected=${at === this.at} @mousedown=${pressed}>
      <b>${key.replaceAll("_", " ")}</b><small>${told}</small></div>`;
  }
}
