/** The shot inspector: one shot large, with everything about its camera that can be changed. */

import { LitElement, html, nothing, type PropertyValues } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { STOPS, lensesOf } from "./camera_kit";
import type { Board, Edit, PanelCard, ShotDetails } from "./messages";
import "./shot_approval";
import "./shot_light";
import "./shot_lines";
import "./shot_parts";
import "./shot_why";
import "./stagings_choose";
import "./takes";
import type { Wire } from "./wire";

@customElement("sb-shot")
export class ShotInspector extends LitElement {
  @property({ attribute: false }) board!: Board;
  @property({ attribute: false }) shot = "";
  @property({ attribute: false }) wire!: Wire;
  @state() private details: ShotDetails | null = null;
  @state() private words: Record<string, string[]> = {};

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  async connectedCallback(): Promise<void> {
    super.connectedCallback();
    const { camera } = await this.wire.call<{ camera: Record<string, Record<string, string>> }>("vocabulary");
    this.words = Object.fromEntries(Object.entries(camera).map(([field, words]) => [field, Object.keys(words)]));
  }

  protected willUpdate(changed: PropertyValues<this>): void {
    if (changed.has("shot") || changed.has("board")) void this.ask();
  }

  private async ask(): Promise<void> {
    const details = await this.wire.call<ShotDetails>("shot", { shot: this.shot }).catch(() => null);
    if (details?.shot === this.shot) this.details = details;
  }

  private edit(...edits: Edit[]): void {
    this.dispatchEvent(new CustomEvent("edit", { detail: edits }));
  }

  private camera(decision: Record<string, unknown>): void {
    this.edit({ kind: "camera", shot: this.shot, decision });
  }

  render() {
    const card = this.board.scenes.flatMap((scene) => scene.shots).find((shot) => shot.shot === this.shot);
    const shot = this.details?.shot === this.shot ? this.details : null;
    if (!card) return nothing;
    return html`
      <aside class="inspector" aria-label="Shot ${this.shot}">
        <div class="head"><h2>${this.shot}</h2>
          <button aria-label="Close" @click=${() => this.dispatchEvent(new Event("close"))}>×</button></div>
        <div class="picture ${card.state}" style="aspect-ratio: ${this.board.aspect}">
          ${card.picture ? html`<img src=${card.picture} alt=${shot?.description ?? ""} />` : nothing}
        </div>
        ${shot ? this.form(shot, card) : html`<p>...</p>`}
      </aside>`;
  }

  private form(shot: ShotDetails, card: PanelCard) {
    const locked = shot.locked.includes("camera");
    return html`
      <p>${shot.description}</p>
      <fieldset ?disabled=${locked}>
        <legend>Camera</legend>
        ${this.choice("Size", "size", shot.size)}
        ${this.choice("Angle", "angle", shot.angle)}
        ${this.choice("Move", "movement", this.move(shot))}
        <label>Lens <select @change=${(event: Event) => this.camera({ lens: Number((event.target as HTMLSelectElement).value) })}>
          ${shot.lens ? nothing : html`<option value="" selected disabled>being set</option>`}
          ${[...new Set([...lensesOf(this.board), ...(shot.lens ? [Math.round(shot.lens)] : [])])].sort((a, b) => a - b).map(
            (lens) => html`<option value=${lens} ?selected=${lens === Math.round(shot.lens)}>${lens} mm</option>`)}
        </select></label>
        <label>Seconds <input type="number" min="0.5" max="600" step="0.5" .value=${String(shot.seconds)}
          @change=${(event: Event) => this.edit({ kind: "duration", shot: this.shot, seconds: Number((event.target as HTMLInputElement).value) })} /></label>
      </fieldset>
      <fieldset ?disabled=${locked}><legend>Who is in the picture, who is sharp</legend>${this.subjects(shot)}</fieldset>
      <sb-light .scene=${card.scene} .revision=${this.board.revision} .wire=${this.wire}
        @edit=${(event: CustomEvent<Edit>) => this.edit(event.detail)}></sb-light>
      ${shot.decided.length ? html`<p class="decided">You decided: ${shot.decided.join(", ")}</p>` : nothing}
      <fieldset><legend>Takes</legend>
        <sb-takes .details=${shot} .card=${card} .aspect=${this.board.aspect} .wire=${this.wire}
          @edit=${(event: CustomEvent<Edit>) => this.edit(event.detail)}></sb-takes>
        <sb-stagings .shot=${this.shot} .aspect=${this.board.aspect} .wire=${this.wire}
          @edit=${(event: CustomEvent<Edit>) => this.edit(event.detail)}></sb-stagings>
      </fieldset>
      <p class="buttons">
        <sb-approval .card=${card} .wire=${this.wire} @edit=${(event: CustomEvent<Edit>) => this.edit(event.detail)}></sb-approval>
        <button ?disabled=${shot.approved} @click=${() => this.edit({ kind: card.locked ? "unlock" : "lock", target: this.shot, parts: [] })}>
          ${card.locked ? "Unlock the shot" : "Lock the shot"}</button>
        <button @click=${() => this.edit({ kind: card.omitted ? "restore" : "omit", target: this.shot })}>
          ${card.omitted ? "Restore" : "Omit"}</button>
      </p>
      <sb-parts .board=${this.board} .details=${shot} @edit=${(event: CustomEvent<Edit>) => this.edit(event.detail)}></sb-parts>
      ${this.notes(shot)}
      ${shot.problems.length ? html`<h3>To check</h3><ul>${shot.problems.map((each) => html`<li>${each}</li>`)}</ul>` : nothing}
      <sb-lines .details=${shot} .cast=${this.board.cast} @edit=${(event: CustomEvent<Edit>) => this.edit(event.detail)}></sb-lines>
      <sb-why .shot=${this.shot} .revision=${this.board.revision} .wire=${this.wire}></sb-why>
    `;
  }

  private notes(shot: ShotDetails) {
    return html`<fieldset class="notes"><legend>Notes</legend>
      ${shot.notes.map((note) => html`<label class=${note.resolved ? "resolved" : ""}>
        <input type="checkbox" .checked=${note.resolved}
          @change=${() => this.edit({ kind: "note", shot: this.shot, action: note.resolved ? "reopen" : "resolve", number: note.number })} />
        <span>${note.author ? html`<b>${note.author}</b> ` : nothing}${note.text}</span></label>`)}
      <form @submit=${(event: SubmitEvent) => this.note(event)}>
        <input aria-label="A note" placeholder="Write a note" maxlength="2000" autocomplete="off" /></form>
    </fieldset>`;
  }

  private note(event: SubmitEvent): void {
    event.preventDefault();
    const field = (event.target as HTMLFormElement).querySelector("input")!;
    const text = field.value.trim();
    if (text) this.edit({ kind: "note", shot: this.shot, action: "add", text });
    field.value = "";
  }

  /** Whom the picture is of, and what is sharp in it. */
  private subjects(shot: ShotDetails) {
    const shown = shot.shows;
    const change = (id: string) => {
      const ids = shown.includes(id) ? shown.filter((each) => each !== id) : [...shown, id];
      if (ids.length) this.camera({ focus_on_ids: ids });
      else this.requestUpdate();
    };
    const people = Object.entries(shot.names);
    const stops = [...new Set([...STOPS, ...(shot.f_number ? [shot.f_number] : [])])].sort((one, other) => one - other);
    return html`${people.map(([id, name]) => html`<label><input type="checkbox" .checked=${shown.includes(id)} @change=${() => change(id)} /> ${name}</label>`)}
      <label>Aperture <select @change=${(event: Event) => this.camera({ f_number: Number((event.target as HTMLSelectElement).value) })}>
        ${shot.f_number ? nothing : html`<option value="" selected disabled>being set</option>`}
        ${stops.map((stop) => html`<option value=${stop} ?selected=${stop === shot.f_number}>f/${stop}</option>`)}</select></label>
      <label>Sharp <select @change=${(event: Event) => this.camera({ focus: (event.target as HTMLSelectElement).value })}>
        ${people.some(([id]) => id === shot.focus[0]) ? nothing : html`<option selected disabled>${shot.focus[0] || (shot.f_number ? "everything" : "being set")}</option>`}
        ${people.map(([id, name]) => html`<option value=${id} ?selected=${id === shot.focus[0]}>${name}</option>`)}</select></label>`;
  }

  /** The move that was asked for: what the shot is said to do has a direction behind it. */
  private move(shot: ShotDetails): string {
    const words = this.words.movement ?? [];
    return words.find((each) => each === shot.movement) ?? words.find((each) => shot.movement.startsWith(each)) ?? shot.movement;
  }

  private choice(label: string, field: string, value: string) {
    const words = this.words[field] ?? [];
    return html`<label>${label} <select data-field=${field}
        @change=${(event: Event) => this.camera({ [field]: (event.target as HTMLSelectElement).value })}>
      ${[...new Set([...words, value])].map((each) => html`<option ?selected=${each === value}>${each}</option>`)}
    </select></label>`;
  }
}
