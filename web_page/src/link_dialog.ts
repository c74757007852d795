/** A dialog with a fresh address that opens the studio in one more browser on this machine. */

import { LitElement, html } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { Wire } from "./wire";

@customElement("sb-link")
export class LinkDialog extends LitElement {
  @property({ attribute: false }) wire!: Wire;
  @state() private address = "";
  @state() private failed = "";
  @state() private copied = false;
  @query("dialog") private dialog!: HTMLDialogElement;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  private async open(): Promise<void> {
    [this.address, this.failed, this.copied] = ["", "", false];
    this.dialog.showModal();
    try {
      this.address = (await this.wire.call<{ address: string }>("link")).address;
    } catch (error) {
      this.failed = (error as Error).message;
    }
  }

  private async copy(): Promise<void> {
    this.querySelector("input")!.select();
    await navigator.clipboard.writeText(this.address).then(() => (this.copied = true), () => (this.failed = "Copy it by hand"));
  }

  render() {
    return html`<button title="Open the studio in another browser on this machine" @click=${() => this.open()}>Another browser</button>
      <dialog class="link" aria-label="Another browser" @keydown=${(event: KeyboardEvent) => event.stopPropagation()}>
        <div class="head"><h2>Another browser</h2><button aria-label="Close" @click=${() => this.dialog.close()}>×</button></div>
        <p>Open this address in it. It works once, on this machine only. An address that was made before and not used works no more.</p>
        <p class="buttons"><input readonly aria-label="Address" .value=${this.failed || this.address || "..."} />
          <button ?disabled=${!this.address} @click=${() => this.copy()}>${this.copied ? "Copied" : "Copy"}</button></p>
      </dialog>`;
  }
}
