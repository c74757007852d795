/** Cast and assets: everybody and everything of the story with a picture, and one of them large, to be changed. */

import { LitElement, html, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import "./asset_look";
import { AssetScene, MEASURE, type Axis } from "./asset_scene";
import "./asset_thing";
import type { AssetCard, AssetDetails, Board, Cast, Edit } from "./messages";
import type { Wire } from "./wire";

const SORTS: [AssetCard["sort"], string][] = [["person", "People"], ["thing", "Things"], ["furniture", "Furniture of the sets"]];

@customElement("sb-assets")
export class AssetsView extends LitElement {
  @property({ attribute: false }) board!: Board;
  @property({ attribute: false }) wire!: Wire;
  @state() private cast: Cast | null = null;
  @state() private details: AssetDetails | null = null;
  /** Who or what is large. */
  @property({ attribute: false }) chosen = "";
  @state() private pictures: Record<string, string> = {};
  @state() private furniture = false;
  @state() private turning = false;
  @state() private loading = false;
  @state() private why = "";
  @query("canvas") private canvas!: HTMLCanvasElement;
  @query(".room") private room!: HTMLElement;
  private scene: AssetScene | null = null;
  private drawing = false;
  private asked = 0;
  private resized = new ResizeObserver(() => this.fit());

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  protected firstUpdated(): void {
    this.scene = new AssetScene(this.canvas);
    this.resized.observe(this.room);
  }

  /** The view fills what the header leaves of the window. */
  private fit(): void {
    this.style.setProperty("--above", `${this.getBoundingClientRect().top + scrollY}px`);
    this.scene?.resize(this.room.clientWidth, this.room.clientHeight);
  }

  disconnectedCallback(): void {
    super.disconnectedCallback();
    this.resized.disconnect();
    this.scene?.dispose();
    this.scene = null;
  }

  protected updated(changed: PropertyValues<this>): void {
    if (changed.has("board") && changed.get("board")?.revision !== this.board.revision) void this.ask();
  }

  /** Ask for all and for the one that is chosen. */
  private async ask(): Promise<void> {
    try {
      this.cast = await this.wire.call<Cast>("assets");
      const there = this.cast.cards.some((card) => card.asset === this.chosen);
      await this.choose(there ? this.chosen : (this.cast.cards[0]?.asset ?? ""));
      void this.drawPictures();
    } catch (error) {
      this.why = (error as Error).message;
    }
  }

  private async choose(asset: string): Promise<void> {
    const same = asset === this.chosen && this.details !== null;
    const asked = ++this.asked;
    [this.chosen, this.why, this.loading] = [asset, "", true];
    this.dispatchEvent(new CustomEvent("chose", { detail: asset }));
    if (!same) [this.details, this.turning] = [null, false];
    if (!asset) return;
    try {
      const details = await this.wire.call<AssetDetails>("asset", { asset });
      if (asked !== this.asked) return;
      this.details = details;
      const model = await this.wire.call<string>("asset_model", { asset });
      if (asked === this.asked && (model !== this.scene?.shown || this.turning)) await this.scene?.show(model, asset);
      this.turning = false;
    } catch (error) {
      if (asked === this.asked) this.why = (error as Error).message;
    }
    if (asked === this.asked) this.loading = false;
  }

  /** Ask for the pictures that are not drawn yet, one by one, so that an edit goes before the next. */
  private async drawPictures(): Promise<void> {
    if (this.drawing) return;
    this.drawing = true;
    const tried = new Set<string>();
    const next = () => this.cast?.cards.find((card) => !card.picture && !tried.has(card.asset) && (this.furniture || card.sort !== "furniture"));
    for (let card = next(); card && this.isConnected; card = next()) {
      tried.add(card.asset);
      try {
        const picture = await this.wire.call<string>("asset_picture", { asset: card.asset });
        card.picture = picture;
        this.pictures = { ...this.pictures, [card.asset]: picture };
      } catch {
        // it has no picture; its details say why
      }
    }
    this.drawing = false;
  }

  private edit(edits: Edit[]): void {
    this.dispatchEvent(new CustomEvent("edit", { detail: edits }));
  }

  private keys(event: KeyboardEvent): void {
    if (!this.scene?.key(event.key)) return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** Show the model as its file has it, in its present pose, to be turned. */
  private async beginTurning(): Promise<void> {
    const { asset, front, top } = this.details!;
    try {
      const model = await this.wire.call<string>("asset_model", { asset, as_in_file: true });
      await this.scene?.show(model, `${asset} as in its file`);
      this.scene?.pose(front || "front", top || "top");
      this.turning = true;
    } catch (error) {
      this.why = (error as Error).message;
    }
  }

  private turn(axis: Axis, quarters: number): void {
    this.scene?.turn(axis, quarters);
  }

  private async endTurning(taken: boolean): Promise<void> {
    if (taken) this.edit([{ kind: "asset", action: "turn", thing: this.chosen, pose: this.scene!.sides }]);
    else await this.choose(this.chosen);
  }

  render() {
    return html`<section class="assets" aria-label="Cast and assets">
      <div class="shelf">${SORTS.map(([sort, label]) => this.shelf(sort, label))}</div>
      <div class="one">
        <div class="stand">
          <div class="room">
            <canvas tabindex="0" role="img" aria-label="${this.details?.name ?? "Nothing"} in 3D; arrows turn it, plus and minus zoom"
              @keydown=${(event: KeyboardEvent) => this.keys(event)}></canvas>
            ${this.loading || this.why ? html`<p class="wait" role="status">${this.why || "Building ..."}</p>` : nothing}
          </div>
          ${this.details ? this.measures(this.details) : nothing}
          ${this.turning ? this.turns() : nothing}
        </div>
        ${this.details ? this.sheet(this.details) : nothing}
      </div>
    </section>`;
  }

  private shelf(sort: AssetCard["sort"], label: string) {
    const cards = this.cast?.cards.filter((card) => card.sort === sort) ?? [];
    if (!cards.length) return nothing;
    const grid = html`<div class="faces ${sort}">${cards.map((card) => this.face(card))}</div>`;
    if (sort !== "furniture") return html`<h2>${label}</h2>${grid}`;
    return html`<details ?open=${this.furniture} @toggle=${(event: Event) => this.open((event.target as HTMLDetailsElement).open)}>
      <summary>${label} (${cards.length})</summary>${this.furniture ? grid : nothing}</details>`;
  }

  private open(furniture: boolean): void {
    this.furniture = furniture;
    if (furniture) void this.drawPictures();
  }

  private face(card: AssetCard) {
    const picture = card.picture || this.pictures[card.asset];
    const marks = [card.decided ? "yours" : "", card.locked ? "locked" : "", card.stand_in ? "stand-in" : ""].filter(Boolean);
    return html`<button class="face ${card.asset === this.chosen ? "chosen" : ""} ${card.picture ? "" : "stale"}" data-asset=${card.asset}
      aria-pressed=${card.asset === this.chosen} title=${card.told} @click=${() => this.choose(card.asset)}>
      <span class="portrait">${picture ? html`<img src=${picture} alt="" />` : nothing}</span>
      <b>${card.name}</b>${marks.length ? html`<small>${marks.join(", ")}</small>` : nothing}</button>`;
  }

  private measures(details: AssetDetails) {
    const [width, depth, height] = details.dimensions.map((side) => (side < 0.1 ? side.toFixed(3) : side.toFixed(2)));
    const square = this.scene?.square ?? 1;
    return html`<p class="measures">${details.look ? html`<b>${height} m</b> tall` : html`<b>${width} × ${depth} × ${height} m</b>`}
      <span>${square < 1 ? "squares of 10 cm" : `squares of 1 m, figure ${MEASURE} m`}</span>
      <button class="quiet" @click=${() => this.scene?.fit()}>Whole view</button></p>`;
  }

  private turns() {
    const turn = (axis: Axis, label: string) => html`<span>${label}
      <button aria-label="${label}, a quarter to the left" @click=${() => this.turn(axis, 1)}>⟲ 90°</button>
      <button aria-label="${label}, a quarter to the right" @click=${() => this.turn(axis, -1)}>⟳ 90°</button></span>`;
    return html`<div class="turns" role="group" aria-label="Front and up">
      <p>Turn it until it stands on its feet and its front looks at you.</p>
      ${turn("z", "Spin")}${turn("x", "Tip forward or back")}${turn("y", "Tip to a side")}
      <button class="primary" @click=${() => this.endTurning(true)}>Take it so</button>
      <button @click=${() => this.endTurning(false)}>Leave it</button></div>`;
  }

  private sheet(details: AssetDetails) {
    return html`<div class="sheet">
      <form class="name" @submit=${(event: SubmitEvent) => this.rename(event)}>
        <input aria-label="Name" .value=${details.name} maxlength="64" autocomplete="off" ?disabled=${details.sort === "furniture"}
          @change=${(event: Event) => this.rename(event)} />
        ${details.sort === "furniture" ? nothing : html`<button type="button" aria-pressed=${details.locked}
          @click=${() => this.edit([{ kind: details.locked ? "unlock" : "lock", target: details.asset }])}>${details.locked ? "Unlock" : "Lock"}</button>`}
      </form>
      ${details.description && details.description !== details.name ? html`<p class="told">${details.description}</p>` : nothing}
      ${details.decisions.length ? html`<p class="decided">You decided: ${details.decisions.join("; ")}
        ${details.locked ? nothing : html`<button class="quiet" data-give-back @click=${() => this.edit([{ kind: "unlock", target: details.asset }])}>Give back to the crew</button>`}</p>` : nothing}
      ${details.look
        ? html`<sb-look .details=${details} .look=${details.look} .choices=${this.cast!.choices} @edit=${this.passed}></sb-look>`
        : html`<sb-thing .details=${details} .finishes=${this.cast!.choices.finishes} .wire=${this.wire} @edit=${this.passed} @turning=${() => this.beginTurning()}></sb-thing>`}
      <h3>Seen in</h3>
      ${details.shown_in.map((each) => html`<p class="seen">${each.title || each.scene}<br />
        ${each.shots.map((shot) => html`<button class="quiet" @click=${() => this.dispatchEvent(new CustomEvent("goto", { detail: shot }))}>${shot}</button>`)}</p>`)}
      ${details.shown_in.length ? nothing : html`<p class="told">In no picture.</p>`}
    </div>`;
  }

  private passed = (event: CustomEvent<Edit[]>): void => {
    event.stopPropagation();
    if (Array.isArray(event.detail)) this.edit(event.detail);
  };

  private rename(event: Event): void {
    event.preventDefault();
    const name = this.querySelector<HTMLInputElement>(".name input")!.value.trim();
    if (name && name !== this.details!.name) this.edit([{ kind: "asset", action: "rename", thing: this.chosen, name }]);
  }
}
