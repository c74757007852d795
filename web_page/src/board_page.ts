/** The first page of the board as it will be printed: the same boxes, with the frames and words of the page. */

import { LitElement, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { BoardPage } from "./deliver_messages";
import type { Board } from "./messages";

@customElement("sb-board-page")
export class BoardPagePreview extends LitElement {
  @property({ attribute: false }) board!: Board;
  @property({ attribute: false }) page!: BoardPage;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  render() {
    const shots = this.board.scenes.flatMap((scene) => scene.shots.filter((shot) => !shot.omitted).map((shot) => ({ ...shot, title: scene.title })));
    const { width, height, cells } = this.page;
    const pages = Math.ceil(shots.length / cells.length);
    return html`<figure class="printed"><div class="paper" style="aspect-ratio: ${width} / ${height}; max-width: min(52rem, ${(80 * width) / height}vh)" role="img" aria-label="First page of the board: ${cells.length} panels">
        ${cells.slice(0, shots.length).map((cell, index) => {
          const shot = shots[index];
          const font = `font-size: ${this.across(cell.size * 0.9)}`;
          return html`
            ${index && shots[index - 1].title === shot.title ? nothing : html`<span class="over" style="${this.place([Math.min(cell.picture[0], cell.words[0]), cell.picture[1] - 14, cell.words[2], 13])}; font-size: ${this.across(9)}">${shot.title}</span>`}
            <div class="frame" style=${this.place(cell.picture)}>${shot.picture ? html`<img src=${shot.picture} alt="" />` : nothing}</div>
            <div class="said" style="${this.place(cell.words)}; ${font}"><b>${shot.shot}</b> <i>${shot.facts}</i>
              ${shot.script.map(([cue, words]) => html`<p>${cue ? html`<i>${cue}</i> ` : nothing}${words}</p>`)}</div>`;
        })}
        <span class="over" style="${this.place([30, 16, width - 60, 18])}; font-size: ${this.across(12)}">${this.board.title}</span>
        <span class="over last" style="${this.place([30, height - 26, width - 60, 14])}; font-size: ${this.across(8)}">1 / ${pages}</span>
      </div><figcaption class="soft">${pages} ${pages === 1 ? "page" : "pages"}</figcaption></figure>`;
  }

  /** Points as a share of the paper's width on the screen. */
  private across(points: number): string {
    return `${((100 * points) / this.page.width).toFixed(3)}cqw`;
  }

  private place([left, top, width, height]: number[]): string {
    return `left: ${this.across(left)}; top: ${this.across(top)}; width: ${this.across(width)}; height: ${this.across(height)}`;
  }
}
