/** What the studio says of what was done; it goes by itself after a while, what could not be done stays until it is dismissed. */

import { LitElement, html, type PropertyValues } from "lit";
import { customElement, property } from "lit/decorators.js";

/** Milliseconds that it stays; longer while the pointer or the focus is on it. */
const STAYS = 8000;

export interface Said {
  text: string;
  wrong: boolean;
}

@customElement("sb-message")
export class MessageBar extends LitElement {
  @property({ attribute: false }) said!: Said;
  private timer = 0;
  /** Where the pointer is in the page: the bar itself lets it through to the work below. */
  private pointer: [number, number] = [-1, -1];

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  private moved = (event: PointerEvent) => (this.pointer = [event.clientX, event.clientY]);

  connectedCallback(): void {
    super.connectedCallback();
    document.addEventListener("pointermove", this.moved);
  }

  disconnectedCallback(): void {
    super.disconnectedCallback();
    document.removeEventListener("pointermove", this.moved);
    window.clearTimeout(this.timer);
  }

  protected updated(changed: PropertyValues<this>): void {
    if (changed.has("said")) this.stay();
  }

  private stay(): void {
    window.clearTimeout(this.timer);
    if (!this.said.wrong) this.timer = window.setTimeout(() => (this.isRead() ? this.stay() : this.dismiss()), STAYS);
  }

  private isRead(): boolean {
    const [x, y] = this.pointer;
    const { left, right, top, bottom } = this.querySelector(".bar")!.getBoundingClientRect();
    return this.matches(":focus-within") || (x >= left && x <= right && y >= top && y <= bottom);
  }

  private dismiss(): void {
    this.dispatchEvent(new Event("dismiss"));
  }

  render() {
    return html`<p class="bar ${this.said.wrong ? "wrong" : ""}" role="status">${this.said.text}
      <button class="quiet" aria-label="Dismiss" @click=${() => this.dismiss()}>×</button></p>`;
  }
}
