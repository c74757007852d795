/** Deliver: the board in a layout of your choice, film, lists, timelines and scenes; what is written, and whether it is new. */

import { LitElement, html, nothing, type PropertyValues } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { BoardLayout, Deliverable, Deliveries } from "./deliver_messages";
import "./board_page";
import type { Board, Status } from "./messages";
import type { Wire } from "./wire";

const PANELS = [1, 2, 3, 4, 6, 9, 12];
const PAPERS: Record<string, string> = { a4: "A4", letter: "Letter", a3: "A3", legal: "Legal", tabloid: "Tabloid" };
const STATES = { fresh: "up to date", old: "older than the story", none: "not written", saved: "saved in Blender, not taken over" };

@customElement("sb-deliver")
export class DeliverView extends LitElement {
  @property({ attribute: false }) board!: Board;
  @property({ attribute: false }) status: Status | null = null;
  /** What was saved in Blender and is not taken over. */
  @property({ attribute: false }) blender = "";
  @property({ attribute: false }) wire!: Wire;
  @state() private found: Deliveries | null = null;
  @state() private layout: BoardLayout | null = null;
  @state() private failed = "";

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  protected willUpdate(changed: PropertyValues<this>): void {
    if (changed.has("board") || changed.has("blender") || changed.get("status")?.busy) void this.ask();
  }

  private async ask(): Promise<void> {
    try {
      const found = await this.wire.call<Deliveries>("deliver", this.layout ? { layout: this.layout } : {});
      [this.found, this.layout, this.failed] = [found, this.layout ?? found.layout, ""];
    } catch (error) {
      this.failed = (error as Error).message;
    }
  }

  private choose(part: Partial<BoardLayout>): void {
    this.layout = { ...this.layout!, ...part };
    void this.ask();
  }

  private write(what: string): void {
    const detail = what === "board" ? { what, layout: this.layout } : { what };
    this.dispatchEvent(new CustomEvent("write", { detail }));
  }

  render() {
    if (this.failed) return html`<p class="bar wrong" role="alert">${this.failed}</p>`;
    if (!this.found || !this.layout) return html`<p>...</p>`;
    const [board, ...others] = this.found.items;
    return html`<section class="deliver" aria-label="Deliver">
      <div class="bound">
        <div>
          <h2>Board</h2>
          ${this.choices(this.layout)}
          ${this.item(board)}
        </div>
        <sb-board-page .board=${this.board} .page=${this.found.page}></sb-board-page>
      </div>
      <h2>Everything else</h2>
      <p class="soft">What shows something else since your last edit is written by itself when you rest for a quarter of a minute; film and exports when you ask.</p>
      <ul class="items">${others.map((item) => html`<li>${this.item(item)}</li>`)}</ul>
    </section>`;
  }

  private choices(layout: BoardLayout) {
    return html`<fieldset><legend>Pages</legend>
      <label>Panels on a page <select data-field="panels" @change=${(event: Event) => this.choose({ panels: Number(value(event)) })}>
        ${PANELS.map((count) => html`<option value=${count} ?selected=${count === layout.panels}>${count}</option>`)}</select></label>
      <label>Paper <select data-field="paper" @change=${(event: Event) => this.choose({ paper: value(event) })}>
        ${Object.entries(PAPERS).map(([key, name]) => html`<option value=${key} ?selected=${key === layout.paper}>${name}</option>`)}</select></label>
      <label>Orientation <select data-field="orientation" @change=${(event: Event) => this.choose({ orientation: value(event) })}>
        ${["landscape", "portrait"].map((way) => html`<option ?selected=${way === layout.orientation}>${way}</option>`)}</select></label>
    </fieldset>`;
  }

  private item(item: Deliverable) {
    const changed = item.what === "board" && JSON.stringify(this.layout) !== JSON.stringify(this.found!.layout);
    const state = changed && item.state === "fresh" ? "old" : item.state;
    return html`<div class="item" data-what=${item.what}>
      <h3>${item.title}</h3><p class="soft">${item.words}</p>
      <p class="when ${state}">${changed ? "in another layout" : STATES[state]}${item.files.length ? html`, written ${when(item.files[0].written)}` : nothing}</p>
      ${item.files.map((file) => html`<a href="/files/${file.name}" download>${file.name.split("/").pop()}</a> <span class="soft">${size(file.bytes)}</span> `)}
      ${this.now(item)}</div>`;
  }

  /** The button that writes something, or how far it is. */
  private now(item: Deliverable) {
    const status = this.status;
    if (status?.busy && status.work === `write ${item.write}`) {
      return html`<p class="busy"><progress max=${status.total || nothing} value=${status.total ? status.step : nothing} aria-label="Writing ${item.title}"></progress>
        <span class="soft">${status.stage}${status.total ? ` ${status.step} of ${status.total}` : ""}</span>
        <button @click=${() => this.dispatchEvent(new Event("stop"))}>Stop</button></p>`;
    }
    const name = item.what === "film" && !item.files.length ? "Make it" : "Write now";
    return html`<p><button ?disabled=${status?.busy} @click=${() => this.write(item.write)} aria-label="${name}: ${item.title}">${name}</button></p>`;
  }
}

function value(event: Event): string {
  return (event.target as HTMLSelectElement).value;
}

function when(written: string): string {
  return new Date(written).toLocaleString(undefined, { dateStyle: "medium", timeStyle: "short" });
}

function size(bytes: number): string {
  return bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1e3))} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
}
