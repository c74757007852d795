/** The board: shots by scene, in the script's words. */

import { LitElement, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { classMap } from "lit/directives/class-map.js";
import { repeat } from "lit/directives/repeat.js";
import type { Board, Edit, PanelCard, SceneCard } from "./messages";

const STATES = { fresh: "", preview: "preview", stale: "being drawn", none: "not drawn" };

@customElement("sb-board")
export class BoardView extends LitElement {
  @property({ attribute: false }) board!: Board;
  @property({ attribute: false }) selected: string[] = [];
  @state() private dragged = "";
  @state() private over = "";

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  private select(shot: string, event: MouseEvent | KeyboardEvent): void {
    const several = event.ctrlKey || event.metaKey;
    const others = this.selected.filter((name) => name !== shot);
    const detail = several ? (others.length < this.selected.length ? others : [...others, shot]) : [shot];
    this.dispatchEvent(new CustomEvent("select", { detail }));
  }

  private edit(edit: Edit): void {
    this.dispatchEvent(new CustomEvent("edit", { detail: [edit] }));
  }

  /** A shot is dropped on another of its scene: it takes that one's place. */
  private drop(shot: string): void {
    const scene = this.board.scenes.find((each) => each.shots.some((card) => card.shot === shot))!;
    const names = scene.shots.map((card) => card.shot);
    const from = names.indexOf(this.dragged);
    const to = names.indexOf(shot);
    if (from >= 0 && from !== to) this.edit({ kind: "reorder", target: this.dragged, [from < to ? "after" : "before"]: shot });
    this.dragged = this.over = "";
  }

  private mayDrop(card: PanelCard): boolean {
    return this.dragged !== "" && this.board.scenes.some((scene) => [this.dragged, card.shot].every((name) => scene.shots.some((each) => each.shot === name)));
  }

  /** Move a shot by one place in its scene. */
  private shift(shot: string, by: number): void {
    const scene = this.board.scenes.find((each) => each.shots.some((card) => card.shot === shot))!;
    const names = scene.shots.map((card) => card.shot);
    const other = names[names.indexOf(shot) + by];
    if (other) this.edit({ kind: "reorder", target: shot, [by > 0 ? "after" : "before"]: other });
  }

  /** Arrows go from shot to shot; those up and down by a row. With Alt they move the shot. */
  private keys(event: KeyboardEvent): void {
    const cards = [...this.querySelectorAll<HTMLElement>(".card")];
    const at = cards.indexOf(event.target as HTMLElement);
    if (at < 0) return;
    if (event.altKey && (event.key === "ArrowLeft" || event.key === "ArrowRight")) {
      event.preventDefault();
      this.shift(cards[at].dataset.shot!, event.key === "ArrowLeft" ? -1 : 1);
      return;
    }
    const row = cards.filter((card) => card.offsetTop === cards[at].offsetTop).length;
    const step = { ArrowLeft: -1, ArrowRight: 1, ArrowUp: -row, ArrowDown: row }[event.key];
    if (step !== undefined) {
      event.preventDefault();
      const next = cards[Math.min(Math.max(at + step, 0), cards.length - 1)];
      next.focus();
      if (this.selected.length) this.select(next.dataset.shot!, event);
    } else if (event.key === "Enter" || event.key === " ") {
      event.preventDefault();
      this.select(cards[at].dataset.shot!, event);
    }
  }

  render() {
    return html`<div class="board" @keydown=${(event: KeyboardEvent) => this.keys(event)}>${this.board.scenes.map(
      (scene) => html`
        ${this.heading(scene)}
        <div class="grid" role="list">${repeat(scene.shots, (shot) => shot.shot, (shot) => this.card(shot))}</div>`,
    )}</div>`;
  }

  private heading(scene: SceneCard) {
    const kind = scene.omitted ? "restore" : "omit";
    return html`<div class="heading"><h2 id=${scene.scene}>${scene.title}${scene.omitted ? " (omitted)" : ""}</h2>
      <button class="quiet" @click=${() => this.edit({ kind, target: scene.scene })}
        title=${scene.omitted ? "Bring the scene back" : "Leave the scene out of the film"}>${scene.omitted ? "Restore" : "Omit"}</button></div>`;
  }

  private card(shot: PanelCard) {
    const chosen = this.selected.includes(shot.shot);
    return html`
      <div role="listitem">
        <div class=${classMap({ card: true, [shot.state]: true, chosen, omitted: shot.omitted, over: this.over === shot.shot })} tabindex="0" role="button" aria-pressed=${chosen}
          aria-label="${shot.shot}, ${shot.facts}" data-shot=${shot.shot}
          draggable="true"
          @dragstart=${() => (this.dragged = shot.shot)}
          @dragend=${() => (this.dragged = this.over = "")}
          @dragover=${(event: DragEvent) => this.mayDrop(shot) && (event.preventDefault(), (this.over = shot.shot))}
          @drop=${(event: DragEvent) => (event.preventDefault(), this.drop(shot.shot))}
          @click=${(event: MouseEvent) => this.select(shot.shot, event)}>
          <div class="picture" style="aspect-ratio: ${this.board.aspect}">
            ${shot.picture ? html`<img src=${shot.picture} alt="" draggable="false" />` : nothing}
            ${shot.omitted ? html`<span class="state">omitted</span>` : STATES[shot.state] ? html`<span class="state">${STATES[shot.state]}</span>` : nothing}
          </div>
          <div class="slate"><b>${shot.shot}</b><span>${shot.seconds.toFixed(1)} s</span></div>
          <div class="facts">${shot.facts}</div>
          ${shot.script.map(([cue, words]) => (cue ? html`<p class="speech"><b>${cue}</b> ${words}</p>` : html`<p>${words}</p>`))}
          <div class="marks">
            ${shot.approved ? html`<span class="approved">approved</span>` : nothing}
            ${shot.notes ? html`<span>${shot.notes === 1 ? "1 note" : `${shot.notes} notes`}</span>` : nothing}
            ${shot.locked && !shot.approved ? html`<span title="Locked">locked</span>` : nothing}
            ${shot.takes > 1 ? html`<span>${shot.takes} takes</span>` : nothing}
            ${shot.problems ? html`<span class="warn">${shot.problems} to check</span>` : nothing}
          </div>
        </div>
      </div>`;
  }
}
