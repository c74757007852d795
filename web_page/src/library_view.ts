/** The user's library: what stories brought in, whose work it is, and which stories use it. */

import { LitElement, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { LibraryCard, ShownLibrary } from "./messages";
import { called } from "./service_name";
import type { Wire } from "./wire";

@customElement("sb-library")
export class LibraryView extends LitElement {
  @property({ attribute: false }) wire!: Wire;
  @state() private shown: ShownLibrary | null = null;
  @state() private failed = "";
  private words = "";
  private asked = 0;
  private drawing = false;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  connectedCallback(): void {
    super.connectedCallback();
    void this.look("");
  }

  /** Ask for what fits the words; only the last answer counts. */
  private async look(words: string): Promise<void> {
    const number = ++this.asked;
    this.words = words.trim();
    try {
      const shown = await this.wire.call<ShownLibrary>("library", { words });
      if (number === this.asked) [this.shown, this.failed] = [shown, ""];
      void this.drawPictures();
    } catch (error) {
      if (number === this.asked) this.failed = (error as Error).message;
    }
  }

  /** Have the pictures of models drawn that are not, one by one, so that an edit goes before the next. */
  private async drawPictures(): Promise<void> {
    if (this.drawing) return;
    this.drawing = true;
    const tried = new Set<string>();
    const next = () => this.shown?.cards.find((card) => !card.picture && card.kind === "model" && !tried.has(card.digest));
    for (let card = next(); card && this.isConnected; card = next()) {
      const { digest } = card;
      tried.add(digest);
      const picture = await this.wire.call<string>("library_picture", { digest }).catch(() => "");
      if (picture && this.shown) this.shown = { ...this.shown, cards: this.shown.cards.map((each) => (each.digest === digest ? { ...each, picture } : each)) };
    }
    this.drawing = false;
  }

  render() {
    const shown = this.shown;
    return html`<section class="library" aria-label="Library">
      <label>Look for <input type="search" maxlength="200" placeholder="name, tag, author or licence"
        @input=${(event: Event) => this.look((event.target as HTMLInputElement).value)} /></label>
      ${this.failed ? html`<p class="wrong" role="alert">${this.failed}</p>` : nothing}
      ${shown ? html`<p role="status">${this.counted(shown)}</p><ul>${shown.cards.map((card) => this.card(card))}</ul>` : nothing}
    </section>`;
  }

  private counted(shown: ShownLibrary) {
    if (!shown.found && !this.words) return html`Your library is empty. What services give your stories is kept in it; <code>storyblender library add</code> adds models and panoramas of yours.`;
    const few = shown.found > shown.cards.length ? `, the newest ${shown.cards.length} are shown` : "";
    const count = shown.found ? `${shown.found} in the library${few}. ` : "Nothing of that is in the library; try fewer words. ";
    return count + (shown.figures ? `${shown.figures}.` : "");
  }

  private card(card: LibraryCard) {
    return html`<li data-entry=${card.digest.slice(0, 8)}>
      ${card.picture ? html`<img src=${card.picture} alt="" loading="lazy" />` : html`<div class="blank">${card.kind}</div>`}
      <div><b>${card.name}</b>
        <span>${card.author || "author not stated"}, ${card.licence || "licence not stated"}</span>
        <span>${card.kind} from ${card.url ? html`<a href=${card.url} target="_blank" rel="noreferrer">${called(card.source)}</a>` : called(card.source)}, ${card.megabytes ? `${card.megabytes} MB` : "less than 0.1 MB"}</span>
        <span>${card.used.length ? `used in ${card.used.join(", ")}` : "not used yet"}</span>
        <code title="Names it on the command line, and as the model of a thing">${card.digest.slice(0, 8)}</code></div>
    </li>`;
  }
}
