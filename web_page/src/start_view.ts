/** Start: drop a script in, or open a project of the folder. */

import { LitElement, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { Places } from "./messages";

@customElement("sb-start")
export class StartView extends LitElement {
  @property({ attribute: false }) places: Places | null = null;
  @state() private over = false;
  @state() private look = "board";
  @state() private animatic = false;
  @state() private crew = "rules";

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  private make(script: string, text?: string): void {
    const detail = { script, text, look: this.look, animatic: this.animatic, crew: this.crew };
    this.dispatchEvent(new CustomEvent("make", { detail }));
  }

  private async take(files: FileList | null | undefined): Promise<void> {
    this.over = false;
    const file = files?.[0];
    if (file) this.make(file.name, await file.text());
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
            @change=${(event: Event) => this.take((event.target as HTMLInputElement).files)} />
        </label>
        <fieldset>
          <label>Look
            <select @change=${(event: Event) => (this.look = (event.target as HTMLSelectElement).value)}>
              <option value="board">Board: lit and inked</option>
              <option value="pencil">Pencil</option>
              <option value="fast">Fast, for trying</option>
            </select>
          </label>
          <label><input type="checkbox" @change=${(event: Event) => (this.animatic = (event.target as HTMLInputElement).checked)} />
            With a film</label>
          <label>Crew
            <input list="crews" .value=${this.crew} autocomplete="off" title="Rules need nothing; a model needs its key or server (docs/crew.md)"
              @change=${(event: Event) => (this.crew = (event.target as HTMLInputElement).value.trim() || "rules")} />
            <datalist id="crews"><option value="rules"></option><option value="google"></option><option value="ollama:"></option><option value="openai:"></option><option value="anthropic:"></option></datalist>
          </label>
        </fieldset>
        ${projects.length
          ? html`<h2>Storyboards</h2><ul class="places">${projects.map(
              (name) => html`<li><button @click=${() => this.dispatchEvent(new CustomEvent("open", { detail: name }))}>${name}</button></li>`,
            )}</ul>`
          : nothing}
        ${scripts.length
          ? html`<h2>Scripts</h2><ul class="places">${scripts.map(
              (name) => html`<li><button @click=${() => this.make(name)}>Make ${name}</button></li>`,
            )}</ul>`
          : nothing}
      </section>
    `;
  }
}
