/** What a thing is made from, how large it is, and what it could be made from instead. */

import { LitElement, html, nothing, type PropertyValues } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { linear } from "./colors";
import type { AssetDetails, Candidate, Edit, OfferedCard, ShownOffers } from "./messages";
import "./own_model";
import { called } from "./service_name";
import type { Wire } from "./wire";

const SIDES = ["width", "depth", "height"] as const;

@customElement("sb-thing")
export class AssetThing extends LitElement {
  @property({ attribute: false }) details!: AssetDetails;
  /** Materials that it can be painted with, and their colours. */
  @property({ attribute: false }) finishes: Record<string, string> = {};
  @property({ attribute: false }) wire!: Wire;
  @state() private candidates: Candidate[] | null = null;
  @state() private offers: ShownOffers | null = null;
  /** The file of what a service is being asked for. */
  @state() private fetching = "";
  @state() private words = "";
  @state() private proportions = true;
  @state() private said = "";
  private asked = 0;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  protected willUpdate(changed: PropertyValues<this>): void {
    const before = changed.get("details") as AssetDetails | undefined;
    if (before && before.asset !== this.details.asset) this.forget();
    else if (before && this.candidates) {
      this.candidates = this.candidates.map((each) => ({ ...each, chosen: (each.file || each.model) === this.details.made_from }));
      this.showOffers((each) => ({ ...each, chosen: each.file === this.details.made_from }));
    }
  }

  private forget(): void {
    this.asked++;
    [this.candidates, this.offers, this.words, this.said] = [null, null, "", ""];
  }

  private showOffers(change: (card: OfferedCard) => OfferedCard): void {
    if (this.offers) this.offers = { ...this.offers, cards: this.offers.cards.map(change) };
  }

  private edit(said: Record<string, unknown>): void {
    const edit: Edit = { kind: "asset", thing: this.details.asset, ...said };
    this.dispatchEvent(new CustomEvent("edit", { detail: [edit] }));
  }

  /** Ask for what it could be made from: what is here at once, what services offer as they answer. */
  private async offer(): Promise<void> {
    const asked = ++this.asked;
    const about = { asset: this.details.asset, words: this.words.trim() };
    [this.candidates, this.offers, this.said] = [null, null, "Looking; the first time takes a moment ..."];
    try {
      const found = await this.wire.call<Candidate[]>("candidates", about);
      if (asked !== this.asked) return;
      [this.candidates, this.said] = [found, ""];
      await Promise.all([this.picture(found, about, asked), this.follow(about, asked)]);
    } catch (error) {
      if (asked === this.asked) this.said = (error as Error).message;
    }
  }

  /** Ask for the pictures of what is here, one by one. */
  private async picture(found: Candidate[], about: object, asked: number): Promise<void> {
    for (const each of found.filter((candidate) => !candidate.picture)) {
      const picture = await this.wire.call<string>("asset_picture", { ...about, digest: each.digest }).catch(() => "");
      if (asked !== this.asked || !this.isConnected) return;
      this.candidates = this.candidates!.map((one) => (one.digest === each.digest ? { ...one, picture } : one));
    }
  }

  /** Ask what services offer until all have answered or failed, then for the pictures of it. */
  private async follow(about: { asset: string; words: string }, asked: number): Promise<void> {
    let offers: ShownOffers;
    do {
      offers = await this.wire.call<ShownOffers>("offers", about);
      if (asked !== this.asked || !this.isConnected) return;
      [this.offers, this.said] = [offers, this.counted(offers)];
      if (offers.waiting.length) await new Promise((done) => setTimeout(done, 1000));
    } while (asked === this.asked && offers.waiting.length);
    for (const each of offers.cards.filter((card) => !card.picture)) {
      const picture = await this.wire.call<string>("offer_picture", { asset: about.asset, file: each.file }).catch(() => "");
      if (asked !== this.asked || !this.isConnected) return;
      this.showOffers((one) => (one.file === each.file ? { ...one, picture } : one));
    }
  }

  private counted({ services, waiting, failures, cards }: ShownOffers): string {
    if (waiting.length) return `Asking ${waiting.map(called).join(" and ")} ...`;
    if (!this.candidates?.length && !cards.length) return "Nothing like it was found; try another word for it.";
    const asked = services.filter((each) => !failures.some((failure) => failure.startsWith(`${called(each)}: `)));
    if (!asked.length || cards.length) return "";
    return `${asked.map(called).join(" and ")} ${asked.length > 1 ? "offer" : "offers"} nothing more like it.`;
  }

  /** Have the thing made from what a service offers, which is fetched first. */
  private take(card: OfferedCard): void {
    const settled = () => (this.fetching = "");
    this.fetching = card.file;
    const detail = { name: "take_offer", call: { thing: this.details.asset, file: card.file }, settled };
    this.dispatchEvent(new CustomEvent("take", { detail, bubbles: true }));
  }

  private resize(side: (typeof SIDES)[number], event: Event): void {
    const input = event.target as HTMLInputElement;
    const length = Number(input.value);
    if (!input.checkValidity() || !(length > 0)) return;
    const [width, depth, height] = this.details.dimensions;
    const dimension = this.proportions ? { [side]: length } : { width, depth, height, [side]: length };
    this.edit({ action: "resize", dimension });
  }

  render() {
    const { details } = this;
    const own = details.sort === "thing";
    return html`
      <p class="told">Made from ${details.source}${details.match !== null && own ? html` <span class="score">fits ${details.match.toFixed(1)} of 10</span>` : nothing}</p>
      ${details.credit ? html`<p class="told">${[details.credit.author, details.credit.license, details.credit.copyright].filter(Boolean).join(", ") || "Nothing is said of whose work it is."}</p>` : nothing}
      ${own ? html`${this.size()}${this.paint()}${this.others()}` : html`<p class="told">It furnishes a set: change it under <i>Set and light</i>, or move and scale it on the stage.</p>`}
      ${details.image_prompt ? html`<details><summary>Words for a service that makes a picture of it</summary><p class="told">${details.image_prompt}</p></details>` : nothing}`;
  }

  private size() {
    const fixed = !this.details.source.startsWith("the library");
    return html`<fieldset ?disabled=${this.details.locked}><legend>Size</legend>
      ${SIDES.map((side, at) => html`<label>${side[0].toUpperCase() + side.slice(1)} <input type="number" data-field=${side} min="0.003" max="60" step="any"
        .value=${String(Number(this.details.dimensions[at].toFixed(3)))} @change=${(event: Event) => this.resize(side, event)} /> m</label>`)}
      <label><input type="checkbox" .checked=${this.proportions} ?disabled=${fixed} @change=${() => (this.proportions = !this.proportions)} /> Keep proportions</label>
      ${this.details.source.startsWith("your model")
        ? html`<button @click=${() => this.dispatchEvent(new Event("turning"))}>Correct front and up</button>`
        : nothing}
    </fieldset>`;
  }

  private painted(look: Record<string, unknown> | null): void {
    const edit: Edit = { kind: "paint", thing: this.details.asset, look };
    this.dispatchEvent(new CustomEvent("edit", { detail: [edit] }));
  }

  private paint() {
    const { color, painted, locked } = this.details;
    return html`<fieldset ?disabled=${locked}><legend>Colour and material</legend>
      <label>Colour <input type="color" data-field="color" .value=${color || "#808080"}
        @change=${(event: Event) => this.painted({ color: linear((event.target as HTMLInputElement).value) })} /></label>
      <label>Material <select data-field="finish" @change=${(event: Event) => this.painted({ finish: (event.target as HTMLSelectElement).value })}>
        <option value="" selected disabled>choose ...</option>
        ${Object.entries(this.finishes).map(([key, tone]) => html`<option value=${key} style="background: ${tone}">${key.replaceAll("_", " ")}</option>`)}</select></label>
      ${painted ? html`<button class="quiet" @click=${() => this.painted(null)}>As it was made</button>` : nothing}
    </fieldset>`;
  }

  private others() {
    return html`<fieldset class="others" ?disabled=${this.details.locked}><legend>Made from something else</legend>
      <form @submit=${(event: SubmitEvent) => (event.preventDefault(), void this.offer())}>
        <input aria-label="What to look for" placeholder="as the script says it, or say what" autocomplete="off" maxlength="64" .value=${this.words}
          @input=${(event: Event) => (this.words = (event.target as HTMLInputElement).value)} />
        <button>Show others</button>
        <button type="button" title="The crew makes it from something else than this" @click=${() => this.edit({ action: "regenerate" })}>Let the crew choose another</button></form>
      ${this.said ? html`<p role="status">${this.said}</p>` : nothing}
      ${(this.offers?.failures ?? []).map((failure) => html`<p class="told" role="status">${failure}</p>`)}
      <div class="faces">${(this.candidates ?? []).map((each) => html`<button class="face ${each.chosen ? "chosen" : ""}" ?disabled=${each.chosen}
        data-candidate=${each.file || each.model} title=${`${each.name}, ${each.source}, fits ${each.score.toFixed(1)} of 10`}
        @click=${() => this.edit({ action: "replace", ...(each.file ? { file: each.file } : { model: each.model }) })}>
        <span class="portrait">${each.picture ? html`<img src=${each.picture} alt="" />` : nothing}</span>
        <b>${each.name}</b><small>${each.chosen ? "chosen" : each.source}</small>${each.credit ? html`<small>${each.credit}</small>` : nothing}</button>`)}</div>
      ${this.offers?.cards.length ? this.fromServices(this.offers.cards) : nothing}
      <sb-own-model .thing=${this.details.asset} .locked=${this.details.locked} @taken=${() => this.candidates && this.offer()}></sb-own-model>
    </fieldset>`;
  }

  private fromServices(cards: OfferedCard[]) {
    return html`<h3>From services</h3><p class="told">What you choose is fetched and kept in your library.</p>
      <div class="faces">${cards.map((each) => html`<button class="face ${each.chosen ? "chosen" : ""}" ?disabled=${each.chosen || this.fetching !== ""}
        data-offer=${each.file} title=${`${each.name}, ${called(each.source)}${each.megabytes ? `, ${each.megabytes} MB` : ""}`} @click=${() => this.take(each)}>
        <span class="portrait">${each.picture ? html`<img src=${each.picture} alt="" />` : nothing}</span>
        <b>${each.name}</b><small>${this.fetching === each.file ? "fetching ..." : called(each.source)}</small><small>${each.credit}</small></button>`)}</div>`;
  }
}
