/** Surfaces or panoramas of the folder and of the library, to choose one by eye. */

import { LitElement, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { PictureCard } from "./messages";
import type { Wire } from "./wire";

const NOTHING = {
  texture: html`There is none. Put colour pictures of surfaces (<code>oak_diff.jpg</code>), or a folder <code>textures</code> of any pictures, beside the storyboard.`,
  panorama: html`There is none. Put .hdr or .exr panoramas beside the storyboard, or add them with <code>storyblender library add</code>.`,
};

@customElement("sb-pictures")
export class PictureChoice extends LitElement {
  @property({ attribute: false }) wire!: Wire;
  @property() kind: "texture" | "panorama" = "texture";
  /** What it is for: Picture for the walls. */
  @property() label = "";
  /** What is used now, as the story names it. */
  @property() now = "";
  /** What there is without one: the finish. */
  @property() without = "";
  @state() private cards: PictureCard[] | null = null;
  @state() private words = "";
  @state() private failed = "";
  private asked = 0;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  /** Ask for what fits the words; only the last answer counts. */
  private async look(words: string): Promise<void> {
    const number = ++this.asked;
    this.words = words;
    try {
      const cards = await this.wire.call<PictureCard[]>("pictures", { kind: this.kind, words });
      if (number === this.asked) [this.cards, this.failed] = [cards, ""];
    } catch (error) {
      if (number === this.asked) this.failed = (error as Error).message;
    }
  }

  private chose(card: PictureCard | null): void {
    const detail = card && (card.entry ? { entry: card.entry } : { file: card.file });
    this.dispatchEvent(new CustomEvent("chose", { detail }));
  }

  render() {
    const known = this.cards?.find((card) => card.named === this.now)?.name;
    const now = known ?? this.now.split("/").pop()!.replace(/\.\w+$/, "").replaceAll("_", " ");
    return html`<details class="pictures" @toggle=${(event: Event) => (event.target as HTMLDetailsElement).open && this.look(this.words)}>
      <summary>${this.label}: <b>${now || this.without}</b></summary>
      <label>Look for <input type="search" maxlength="200" placeholder="name, tag or author" .value=${this.words}
        @input=${(event: Event) => this.look((event.target as HTMLInputElement).value)} /></label>
      ${this.now ? html`<button class="quiet" data-none @click=${() => this.chose(null)}>Back to ${this.without}</button>` : nothing}
      ${this.failed ? html`<p class="wrong" role="alert">${this.failed}</p>` : nothing}
      ${this.cards && !this.cards.length ? html`<p class="told" role="status">${this.words ? "Nothing of that is there." : NOTHING[this.kind]}</p>` : nothing}
      <div class="faces">${(this.cards ?? []).map((card) => this.card(card))}</div>
    </details>`;
  }

  private card(card: PictureCard) {
    const chosen = this.now !== "" && card.named === this.now;
    return html`<button class="face ${chosen ? "chosen" : ""}" aria-pressed=${chosen} data-picture=${card.entry || card.file} title=${`${card.name}, ${card.source}`}
      @click=${() => this.chose(card)}><span class="portrait"><img src=${card.picture} alt="" loading="lazy" @error=${hide} /></span>
      <b>${card.name}</b><small>${card.source}</small>${card.credit ? html`<small>${card.credit}</small>` : nothing}</button>`;
  }
}

/** A picture that cannot be made leaves its place empty. */
function hide(event: Event): void {
  (event.target as HTMLElement).hidden = true;
}
