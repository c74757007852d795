/** The approval of a shot, by what its picture shows: an old picture is drawn first, and looked at. */

import { LitElement, html, nothing, type PropertyValues } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { Edit, PanelCard } from "./messages";
import type { Wire } from "./wire";

/** What is to be said of a picture that nobody can approve the shot by. */
const UNSEEN = { none: "It is not drawn yet", stale: "This picture is older than the shot", preview: "This is only a quick preview" };

@customElement("sb-approval")
export class ShotApproval extends LitElement {
  @property({ attribute: false }) card!: PanelCard;
  @property({ attribute: false }) wire!: Wire;
  /** Whether an approval waits for the picture that it is about. */
  @state() private asked = false;
  @state() private drawing = false;
  @state() private failed = "";

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  protected willUpdate(changed: PropertyValues<this>): void {
    const before = changed.get("card");
    if (before && before.shot !== this.card.shot) [this.asked, this.failed] = [false, ""];
    if (this.card.state === "fresh") this.failed = "";
  }

  private approve(): void {
    const { approved, shot, state, omitted } = this.card;
    this.asked = !approved && !omitted && state !== "fresh";
    if (this.asked) return;
    const edit: Edit = { kind: "approve", shot, approved: !approved };
    this.dispatchEvent(new CustomEvent("edit", { detail: edit }));
  }

  private async draw(): Promise<void> {
    [this.drawing, this.failed] = [true, ""];
    await this.wire.call("draw", { shot: this.card.shot }).catch((error: Error) => (this.failed = error.message));
    this.drawing = false;
  }

  render() {
    const { approved, state } = this.card;
    return html`<button @click=${() => this.approve()}>${approved ? "Withdraw approval" : "Approve"}</button>
      ${this.asked && !approved ? this.question(state) : nothing}`;
  }

  private question(state: PanelCard["state"]) {
    if (state === "fresh") return html`<span role="status">This is the shot as it is now.</span>`;
    return html`<span role="status">${this.failed || `${UNSEEN[state]}. Look at the finished one, then approve it.`}
      <button ?disabled=${this.drawing} @click=${() => this.draw()}>${this.drawing ? "Drawing ..." : "Draw it now"}</button></span>`;
  }
}
