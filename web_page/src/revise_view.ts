/** A revised script: what it would change, shot by shot, before it is taken over. */

import { LitElement, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { ScriptChanges, ShotChange } from "./messages";
import type { Wire } from "./wire";

const KINDS: Record<ShotChange["kind"], string> = { new: "New", changed: "Changed", moved: "Moved", omitted: "Omitted" };

@customElement("sb-revise")
export class ReviseView extends LitElement {
  @property({ attribute: false }) wire!: Wire;
  @state() private script = "";
  @state() private changes: ScriptChanges | null = null;
  @state() private failed = "";
  @state() private reading = false;
  private text = "";

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  private async take(files: FileList | null | undefined): Promise<void> {
    const file = files?.[0];
    if (!file) return;
    this.changes = null;
    this.failed = "";
    this.script = file.name;
    this.text = await file.text();
    this.reading = true;
    try {
      this.changes = await this.wire.call<ScriptChanges>("compare", { script: this.script, text: this.text });
    } catch (error) {
      this.failed = (error as Error).message;
    }
    this.reading = false;
  }

  private apply(): void {
    this.dispatchEvent(new CustomEvent("revise", { detail: { script: this.script, text: this.text } }));
  }

  render() {
    return html`<section class="revise" aria-label="Revised script">
      <label class="drop" @dragover=${(event: DragEvent) => event.preventDefault()}
        @drop=${(event: DragEvent) => (event.preventDefault(), this.take(event.dataTransfer?.files))}>
        <b>Drop the revised script here</b>
        <span>What it changes is listed first; what you decided stays with the words of its shot</span>
        <input type="file" accept=".fountain,.fdx,.txt,.md" aria-label="Choose the revised script"
          @change=${(event: Event) => this.take((event.target as HTMLInputElement).files)} />
      </label>
      ${this.reading ? html`<p role="status">Reading ${this.script} ...</p>` : nothing}
      ${this.failed ? html`<p class="wrong" role="alert">${this.failed}</p>` : nothing}
      ${this.changes ? this.listed(this.changes) : nothing}
    </section>`;
  }

  private listed(changes: ScriptChanges) {
    const renamed = Object.keys(changes.renamed).length;
    return html`
      <h2>${changes.shots.length ? `${this.script} changes ${changes.shots.length === 1 ? "one shot" : `${changes.shots.length} shots`}` : "No shot changes"}</h2>
      <p>${changes.kept_scenes.length} of ${changes.scenes} scenes stay as they are staged${renamed ? `; ${renamed} shots only get another number` : ""}.</p>
      ${changes.lost.map(([name, decided]) => html`<p class="wrong">Not kept: ${name}, ${decided}. The words under it changed.</p>`)}
      ${changes.shots.length
        ? html`<table><thead><tr><th>Change</th><th>Shot</th><th>Was</th><th>Words</th></tr></thead><tbody>
            ${changes.shots.map((shot) => html`<tr class=${shot.kind}><td>${KINDS[shot.kind]}</td><td>${shot.shot}</td>
              <td>${shot.former === shot.shot ? "" : shot.former}</td>
              <td>${shot.former_words ? html`<del>${shot.former_words}</del> ` : nothing}${shot.kind === "omitted" ? html`<del>${shot.words}</del>` : shot.words}</td></tr>`)}
          </tbody></table>`
        : nothing}
      <p class="buttons"><button class="primary" @click=${() => this.apply()}>Take it over</button> Undo takes it back.</p>`;
  }
}
