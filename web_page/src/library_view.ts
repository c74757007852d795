/** The user's library: what stories brought in, whose work it is, and which stories use it. */

import { LitElement, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { LibraryCard, ShownLibrary } from "./messages";
import type { Wire } from "./wire";

@customElement("sb-library")
export class LibraryView extends LitElement {
  @property({ attribute: false }) wire!: Wire;
  @state() private shown: ShownLibrary | null = null;
  @state() private failed = "";
  private asked = 0;

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
    try {
      const shown = await this.wire.call<ShownLibrary>("library", { words });
      if (number === this.asked) [this.shown, this.failed] = [shown, ""];
    } catch (error) {
      if (number === this.asked) this.failed = (error as Error).message;
    }
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

  private counted(shown: ShownLibrary): string {
    const few = shown.found > shown.cards.length ? `, the newest ${shown.cards.length} are shown` : "";
    const count = shown.found ? `${shown.found} in the library${few}. ` : "Nothing of that is in the library. ";
    return count + (shown.figures ? `${shown.figures}.` : "");
  }

  private card(card: LibraryCard) {
    return html`<li data-entry=${card.digest.slice(0, 8)}>
      ${card.picture ? html`<img src=${card.picture} alt="" loading="lazy" />` : html`<div class="blank">${card.kind}</div>`}
      <div><b>${card.name}</b>
        <span>${card.author || "author not stated"}, ${card.licence || "licence not stated"}</span>
        <span>${card.kind} from ${card.url ? html`<a href=${card.url} target="_blank" rel="noreferrer">${card.source}</a>` : card.source}, ${card.megabytes} MB</span>
        <span>${card.used.length ? `used in ${card.used.join(", ")}` : "not used yet"}</span>
        <code title="Names it on the command line, and as the model of a thing">${card.digest.slice(0, 8)}</code></div>
    </li>`;
  }
}
