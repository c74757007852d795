/** Two takes of a shot beside each other, or one wiped over the other, to choose between them. */

import { LitElement, html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { Edit, PanelCard, ShotDetails, Take } from "./messages";
import { takesOf, type TakesOf } from "./takes";
import type { Wire } from "./wire";

/** What is said on the picture of the film's take where it is not the finished one of the take as it is. */
const MARKS = { fresh: "", preview: "quick preview", stale: "older than the take", none: "" };

@customElement("sb-compare")
export class TakesCompare extends LitElement {
  @property({ attribute: false }) details!: ShotDetails;
  @property({ attribute: false }) of: TakesOf = "camera";
  /** The shot on the board, whose picture is that of the take that the film shows. */
  @property({ attribute: false }) card!: PanelCard;
  @property({ attribute: false }) aspect = 16 / 9;
  @property({ attribute: false }) wire!: Wire;
  @state() private pictures: Record<number, string> = {};
  @state() private waiting = false;
  @state() private failed = "";
  /** Numbers of the takes whose pictures are only quick ones. */
  private quick = new Set<number>();
  /** Number of the take that a picture is being made of. */
  @state() private drawing = 0;
  @state() private pair: [number, number] = [0, 0];
  @state() private wipe = false;
  @state() private edge = 50;
  @query("dialog") private dialog!: HTMLDialogElement;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  private get takes(): Take[] {
    return takesOf(this.details, this.of);
  }

  /** Show the take of the film beside the first other one. */
  async open(): Promise<void> {
    const shown = this.takes.find((take) => take.in_film)!.number;
    this.pair = [this.takes.find((take) => !take.in_film)!.number, shown];
    [this.pictures, this.waiting, this.failed] = [{}, true, ""];
    this.quick = new Set(this.of === "camera" ? [] : this.takes.map((take) => take.number));
    this.dialog.showModal();
    try {
      this.pictures = await this.wire.call<Record<number, string>>("takes", { shot: this.details.shot, of: this.of });
    } catch (error) {
      this.failed = (error as Error).message;
    }
    this.waiting = false;
  }

  /** Draw a take now: that of the film as its frame, another one as a small picture. */
  private async draw(take: Take): Promise<void> {
    const { shot } = this.details;
    [this.drawing, this.failed] = [take.number, ""];
    try {
      if (take.in_film) await this.wire.call("draw", { shot });
      else {
        const picture = await this.wire.call<string>("draw_take", { shot, of: this.of, number: take.number });
        this.quick.add(take.number);
        this.pictures = { ...this.pictures, [take.number]: picture };
      }
    } catch (error) {
      this.failed = (error as Error).message;
    }
    this.drawing = 0;
  }

  private choose(number: number): void {
    const edit: Edit = { kind: "take", shot: this.details.shot, of: this.of, action: "choose", number };
    this.dispatchEvent(new CustomEvent("edit", { detail: edit }));
    this.dialog.close();
  }

  render() {
    return html`<dialog class="compare" aria-label="Takes of ${this.details.shot}" @keydown=${(event: KeyboardEvent) => event.stopPropagation()}>
      <div class="head"><h2>${this.details.shot}: takes of the ${this.of}</h2>
        <label><input type="checkbox" .checked=${this.wipe} @change=${() => (this.wipe = !this.wipe)} /> One over the other</label>
        <button aria-label="Close" @click=${() => this.dialog.close()}>×</button></div>
      ${this.wipe ? this.wiped() : html`<div class="pair">${[0, 1].map((side) => this.side(side))}</div>`}
    </dialog>`;
  }

  private side(side: number) {
    const take = this.takes.find((each) => each.number === this.pair[side]);
    return html`<section>${this.shown(this.pair[side])}${this.picker(side)}
      <p>${[take?.camera, ...(take?.decided ?? [])].filter(Boolean).join(", ") || "as the crew made it"}</p>
      <button ?disabled=${take?.in_film} @click=${() => this.choose(this.pair[side])}>${take?.in_film ? "In the film" : "Choose this take"}</button></section>`;
  }

  private wiped() {
    return html`<div class="over" style="aspect-ratio: ${this.aspect}">${this.shown(this.pair[0])}
        <div class="upper" style="clip-path: inset(0 0 0 ${this.edge}%)">${this.shown(this.pair[1])}</div></div>
      <label>Wipe <input type="range" min="0" max="100" .value=${String(this.edge)}
        @input=${(event: Event) => (this.edge = Number((event.target as HTMLInputElement).value))} /></label>
      <div class="pair">${[0, 1].map((side) => this.picker(side))}</div>`;
  }

  private shown(number: number) {
    const take = this.takes.find((each) => each.number === number);
    if (!take) return nothing;
    const address = take.in_film ? this.card.picture : this.pictures[number];
    const mark = take.in_film ? MARKS[this.card.state] : address && this.quick.has(number) ? MARKS.preview : "";
    return html`<div class="picture ${take.in_film ? this.card.state : ""}" style="aspect-ratio: ${this.aspect}">
      ${address ? html`<img src=${address} alt="Take ${number}" />` : nothing}
      ${mark ? html`<span class="state">${mark}</span>` : nothing}
      ${address && (!take.in_film || !mark) ? nothing : this.offer(take, address)}</div>`;
  }

  /** What there is in place of a picture of a take, or over an old one: a button that draws it. */
  private offer(take: Take, address: string) {
    if (this.waiting && !take.in_film) return html`<p class="undrawn">Being drawn ...</p>`;
    const drawn = this.drawing === take.number;
    return html`<p class="undrawn ${address ? "beneath" : ""}">${this.failed || (address ? "" : `Take ${take.number} is not drawn`)}
      <button ?disabled=${!!this.drawing} @click=${() => this.draw(take)}>${drawn ? "Drawing ..." : "Draw it now"}</button></p>`;
  }

  private picker(side: number) {
    return html`<select aria-label=${side ? "Right take" : "Left take"} @change=${(event: Event) => this.pick(side, Number((event.target as HTMLSelectElement).value))}>
      ${this.takes.map((take) => html`<option value=${take.number} ?selected=${take.number === this.pair[side]}>Take ${take.number}${take.in_film ? ", in the film" : ""}</option>`)}
    </select>`;
  }

  private pick(side: number, number: number): void {
    this.pair = side ? [this.pair[0], number] : [number, this.pair[1]];
  }
}
