/** Start: drop a script in, or open a project of the folder; look and crew are chosen before the work begins. */

import { LitElement, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { Places } from "./messages";

const LOOKS = { board: "Board: lit and inked", pencil: "Pencil", fast: "Fast, for trying" };
const CREWS = ["rules", "google", "ollama:", "openai:", "anthropic:"];

@customElement("sb-start")
export class StartView extends LitElement {
  @property({ attribute: false }) places: Places | null = null;
  @state() private over = false;
  /** The script that is to be made: one of the folder, or with its text one that was dropped in. */
  @state() private script: { name: string; text?: string } | null = null;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  private async take(files: FileList | null | undefined): Promise<void> {
    this.over = false;
    const file = files?.[0];
    if (file) this.choose(file.name, await file.text());
  }

  private async choose(name: string, text?: string): Promise<void> {
    this.script = { name, text };
    await this.updateComplete;
    this.querySelector<HTMLElement>(".ready .primary")!.focus();
  }

  private make(event: SubmitEvent): void {
    event.preventDefault();
    const form = new FormData(event.target as HTMLFormElement);
    const { name, text } = this.script!;
    const detail = {
      script: name, text, look: form.get("look"), animatic: form.has("animatic"), crew: String(form.get("crew")).trim() || "rules",
    };
    this.dispatchEvent(new CustomEvent("make", { detail }));
  }

  render() {
    const { scripts, projects } = this.places ?? { scripts: [], projects: [] };
    return html`
      <section class="start">
        <label class="drop ${this.over ? "over" : ""}"
          @dragover=${(event: DragEvent) => (event.preventDefault(), (this.over = true))}
          @dragleave=${() => (this.over = false)}
          @drop=${(event: DragEvent) => (event.preventDefault(), this.take(event.dataTransfer?.files))}>
          <b>Drop a script here</b>
          <span>Fountain, Final Draft, or plain prose; or choose a file</span>
          <input type="file" accept=".fountain,.fdx,.txt,.md" aria-label="Choose a script"
            @click=${(event: Event) => ((event.target as HTMLInputElement).value = "")}
            @change=${(event: Event) => this.take((event.target as HTMLInputElement).files)} />
        </label>
        ${this.script ? this.ready(this.script.name) : nothing}
        ${projects.length
          ? html`<h2>Storyboards</h2><ul class="places">${projects.map(
              (name) => html`<li><button @click=${() => this.dispatchEvent(new CustomEvent("open", { detail: name }))}>${name}</button></li>`,
            )}</ul>`
          : nothing}
        ${scripts.length
          ? html`<h2>Scripts</h2><ul class="places">${scripts.map(
              (name) => html`<li><button aria-pressed=${this.script?.name === name} class=${this.script?.name === name ? "chosen" : ""}
                @click=${() => this.choose(name)}>Make ${name}</button></li>`,
            )}</ul>`
          : nothing}
      </section>
    `;
  }

  /** The script that was chosen, how it is drawn and by whom, and the button that starts the work. */
  private ready(name: string) {
    return html`<form class="ready" aria-label="Make ${name}" @submit=${(event: SubmitEvent) => this.make(event)}>
      <h2>${name}</h2>
      <label>Look <select name="look">${Object.entries(LOOKS).map(([look, words]) => html`<option value=${look}>${words}</option>`)}</select></label>
      <label>Crew <input name="crew" list="crews" value="rules" autocomplete="off" title="Rules need nothing; a model needs its key or server (docs/crew.md)" />
        <datalist id="crews">${CREWS.map((crew) => html`<option value=${crew}></option>`)}</datalist></label>
      <label><input name="animatic" type="checkbox" /> With a film</label>
      <p><button class="primary">Start</button> <button type="button" @click=${() => (this.script = null)}>Not this one</button></p>
    </form>`;
  }
}
