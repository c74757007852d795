/** Other stagings of a shot's scene beside each other, to choose one. */

import { LitElement, html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { Edit, StagingCard } from "./messages";
import type { Wire } from "./wire";

@customElement("sb-stagings")
export class StagingsChoose extends LitElement {
  @property({ attribute: false }) shot = "";
  @property({ attribute: false }) aspect = 16 / 9;
  @property({ attribute: false }) wire!: Wire;
  @state() private found: StagingCard[] = [];
  @state() private said = "";
  @query("dialog") private dialog!: HTMLDialogElement;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  private async open(): Promise<void> {
    [this.found, this.said] = [[], "Trying other stagings; this takes a minute or two ..."];
    this.dialog.showModal();
    try {
      this.found = await this.wire.call<StagingCard[]>("propose", { shot: this.shot });
      this.said = this.found.length ? "" : "No other staging without a fault was found.";
    } catch (error) {
      this.said = (error as Error).message;
    }
  }

  private choose(staging: number): void {
    const edit: Edit = { kind: "layout", scene: this.shot.split("_")[0], staging };
    this.dispatchEvent(new CustomEvent("edit", { detail: edit }));
    this.dialog.close();
  }

  render() {
    return html`<button @click=${() => this.open()}>Other stagings</button>
      <dialog class="compare" aria-label="Stagings of ${this.shot}" @keydown=${(event: KeyboardEvent) => event.stopPropagation()}>
        <div class="head"><h2>${this.shot}: other stagings</h2>
          <button aria-label="Close" @click=${() => this.dialog.close()}>×</button></div>
        ${this.said ? html`<p role="status">${this.said}</p>` : nothing}
        <div class="pair">${this.found.map((each) => html`<section>
          <div class="picture" style="aspect-ratio: ${this.aspect}"><img src=${each.picture} alt="Staging ${each.number}" /></div>
          <p>${each.moved}</p>
          <button @click=${() => this.choose(each.number)}>Choose staging ${each.number}</button></section>`)}</div>
      </dialog>`;
  }
}
