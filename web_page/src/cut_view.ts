/** The cut: the film played from its frames, over a timeline on which shots are trimmed, moved and left out. */

import { LitElement, html, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { placed, shotAt, speechAt, timecode, type Placed } from "./cut_times";
import type { Board, Cut, Edit } from "./messages";
import type { Wire } from "./wire";

/** Fewest frames that a shot is trimmed to. */
const LEAST = 6;

@customElement("sb-cut")
export class CutView extends LitElement {
  @property({ attribute: false }) board!: Board;
  @property({ attribute: false }) selected: string[] = [];
  @property({ attribute: false }) wire!: Wire;
  @state() private cut: Cut | null = null;
  @state() private frame = 0;
  @state() private playing = false;
  @state() private zoom = 1;
  @state() private film = false;
  @state() private trim: { shot: string; frames: number } | null = null;
  @state() private dragged = "";
  private shots: Placed[] = [];
  @query(".track") private track!: HTMLElement;
  @query("video") private video!: HTMLVideoElement | null;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  connectedCallback(): void {
    super.connectedCallback();
    document.addEventListener("keydown", this.keys);
  }

  disconnectedCallback(): void {
    super.disconnectedCallback();
    document.removeEventListener("keydown", this.keys);
    this.playing = false;
  }

  protected willUpdate(changed: PropertyValues<this>): void {
    if (changed.has("board")) void this.ask();
    this.shots = this.cut ? placed(this.cut, this.trim) : [];
  }

  private async ask(): Promise<void> {
    const cut = await this.wire.call<Cut>("cut");
    const first = this.cut === null;
    this.cut = cut;
    await this.updateComplete;
    const start = this.shots.find((shot) => shot.shot === this.selected[0])?.start ?? 0;
    this.frame = first ? start : Math.min(this.frame, this.length - 1);
  }

  private get length(): number {
    return this.shots.reduce((sum, shot) => sum + shot.frames, 0);
  }

  private seek(frame: number): void {
    this.frame = Math.max(0, Math.min(Math.round(frame), this.length - 1));
    if (this.video && this.cut) this.video.currentTime = this.frame / this.cut.fps;
  }

  private play(): void {
    this.playing = !this.playing;
    if (!this.playing || !this.cut) return void this.video?.pause();
    if (this.frame >= this.length - 1) this.seek(0);
    void this.video?.play();
    const [from, began, fps] = [this.frame, performance.now(), this.cut.fps];
    const step = (now: number) => {
      if (!this.playing || !this.isConnected) return;
      this.frame = Math.min(from + Math.floor(((now - began) / 1000) * fps), this.length - 1);
      if (this.frame >= this.length - 1) this.playing = false;
      else requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  private keys = (event: KeyboardEvent): void => {
    if ((event.target as HTMLElement).closest("input, textarea, select, dialog") || event.ctrlKey || event.metaKey) return;
    const here = shotAt(this.shots, this.frame);
    const at = here ? this.shots.indexOf(here) : 0;
    const done: Record<string, () => void> = {
      " ": () => this.play(),
      Home: () => this.seek(0),
      End: () => this.seek(this.length - 1),
      ArrowLeft: () => this.seek(event.shiftKey ? (this.shots[Math.max(at - 1, 0)]?.start ?? 0) : this.frame - 1),
      ArrowRight: () => this.seek(event.shiftKey ? (this.shots[at + 1]?.start ?? this.length - 1) : this.frame + 1),
      "[": () => here && this.resize(here, -1),
      "]": () => here && this.resize(here, 1),
    };
    if (event.altKey && here && event.key.startsWith("Arrow")) {
      event.preventDefault();
      this.shift(here, event.key === "ArrowLeft" ? -1 : 1);
    } else if (done[event.key]) {
      event.preventDefault();
      if (event.key === " " && (event.target as HTMLElement).closest("button")) (event.target as HTMLElement).blur();
      done[event.key]();
    }
  };

  private edit(...edits: Edit[]): Promise<boolean> {
    return new Promise((settled) => this.dispatchEvent(new CustomEvent("edit", { detail: { edits, settled } })));
  }

  private resize(shot: Placed, frames: number): void {
    if (!shot.fixed) void this.edit({ kind: "duration", shot: shot.shot, frames: Math.max(shot.frames + frames, LEAST) });
  }

  /** Move a shot by one place in its scene. */
  private shift(shot: Placed, by: number): void {
    const other = this.shots[this.shots.indexOf(shot) + by];
    if (other?.scene === shot.scene) this.move(shot.shot, other.shot, by > 0);
  }

  private move(shot: string, other: string, after: boolean): void {
    void this.edit({ kind: "reorder", target: shot, [after ? "after" : "before"]: other });
  }

  private drop(onto: Placed): void {
    const own = this.shots.find((shot) => shot.shot === this.dragged);
    if (own && own !== onto && own.scene === onto.scene) this.move(own.shot, onto.shot, own.start < onto.start);
    this.dragged = "";
  }

  /** The end of a shot follows the pointer, and all that is after it; Escape gives it up. */
  private grab(event: PointerEvent, shot: Placed): void {
    event.preventDefault();
    event.stopPropagation();
    const handle = event.currentTarget as HTMLElement;
    const [from, perFrame] = [event.clientX, this.track.scrollWidth / this.length];
    handle.setPointerCapture(event.pointerId);
    const follow = (move: PointerEvent) => {
      const frames = Math.max(LEAST, Math.round(shot.frames + (move.clientX - from) / perFrame));
      this.trim = { shot: shot.shot, frames };
    };
    const escape = (key: KeyboardEvent) => key.key === "Escape" && (key.stopPropagation(), end(false));
    const end = (keep: boolean) => {
      handle.removeEventListener("pointermove", follow);
      document.removeEventListener("keydown", escape, true);
      const trim = this.trim;
      if (!keep || !trim || trim.frames === shot.frames) return void (this.trim = null);
      void this.edit({ kind: "duration", shot: shot.shot, frames: trim.frames }).then(() => (this.trim = null));
    };
    handle.addEventListener("pointermove", follow);
    handle.addEventListener("pointerup", () => end(true), { once: true });
    handle.addEventListener("pointercancel", () => end(false), { once: true });
    document.addEventListener("keydown", escape, true);
  }

  private select(shot: Placed): void {
    this.dispatchEvent(new CustomEvent("select", { detail: [shot.shot] }));
    this.seek(shot.start);
  }

  render() {
    if (!this.cut) return html`<p class="wait">...</p>`;
    const [shots, fps] = [this.shots, this.cut.fps];
    const here = shotAt(shots, this.frame);
    return html`<section class="cut" aria-label="Cut">
      ${this.screen(here)}
      <div class="transport">
        <button @click=${() => this.play()} aria-label=${this.playing ? "Pause" : "Play"}>${this.playing ? "❚❚" : "▶"}</button>
        <output aria-label="Timecode">${timecode(this.frame, fps)}</output><span>of ${timecode(this.length, fps)}</span>
        <span class="space"></span>
        ${here ? this.tools(here) : nothing}
        <label>Zoom <input type="range" min="1" max="12" step="0.5" .value=${String(this.zoom)}
          @input=${(event: Event) => (this.zoom = Number((event.target as HTMLInputElement).value))} /></label>
        ${this.board.film ? html`<label><input type="checkbox" .checked=${this.film} @change=${() => (this.film = !this.film)} /> Film</label>` : nothing}
      </div>
      <div class="timeline" tabindex="0" aria-label="Timeline"><div class="track" style="width: ${this.zoom * 100}%">
        <input class="playhead" type="range" min="0" max=${this.length - 1} .value=${String(this.frame)} aria-label="Frame of the film"
          @input=${(event: Event) => this.seek(Number((event.target as HTMLInputElement).value))} />
        <div class="scenes">${this.scenes(shots)}</div>
        <div class="shots" role="list">${shots.map((shot) => this.bar(shot, here))}</div>
        <div class="speeches">${shots.flatMap((shot) => shot.speech.map((each) => html`<span
          style=${this.at(shot.start + each.start, each.end - each.start)} title="${each.speaker}: ${each.words}"><b>${each.speaker}</b> ${each.words}</span>`))}</div>
        <div class="now" style="left: ${(this.frame / this.length) * 100}%"></div>
      </div></div>
    </section>`;
  }

  private screen(here: Placed | undefined) {
    const picture = this.board.scenes.flatMap((scene) => scene.shots).find((card) => card.shot === here?.shot)?.picture;
    const said = speechAt(here, this.frame);
    return html`<div class="screen" style="aspect-ratio: ${this.board.aspect}; width: min(100%, ${50 * this.board.aspect}vh)">
      ${this.film && this.board.film
        ? html`<video src=${this.board.film} muted preload="auto"></video>`
        : picture ? html`<img src=${picture} alt=${here?.shot ?? ""} />` : nothing}
      ${said && !this.film ? html`<p class="subtitle"><b>${said.speaker}</b> ${said.words}</p>` : nothing}
      <span class="state">${here?.shot}${here && this.cut!.stale.includes(here.shot) ? ", being drawn" : ""}</span>
    </div>`;
  }

  private tools(here: Placed) {
    const fps = this.cut!.fps;
    const [at, shots] = [this.shots.indexOf(here), this.shots];
    return html`
      <button ?disabled=${here.fixed} @click=${() => this.resize(here, -Math.round(fps / 2))}>Shorter</button>
      <button ?disabled=${here.fixed} @click=${() => this.resize(here, Math.round(fps / 2))}>Longer</button>
      <button ?disabled=${shots[at - 1]?.scene !== here.scene} @click=${() => this.shift(here, -1)}>Earlier</button>
      <button ?disabled=${shots[at + 1]?.scene !== here.scene} @click=${() => this.shift(here, 1)}>Later</button>
      <button @click=${() => this.edit({ kind: "omit", target: here.shot })}>Omit</button>`;
  }

  private at(start: number, frames: number): string {
    return `left: ${(start / this.length) * 100}%; width: ${(frames / this.length) * 100}%`;
  }

  private scenes(shots: Placed[]) {
    const bands = new Map<string, { title: string; start: number; frames: number }>();
    for (const shot of shots) {
      const band = bands.get(shot.scene) ?? { title: shot.title, start: shot.start, frames: 0 };
      bands.set(shot.scene, { ...band, frames: band.frames + shot.frames });
    }
    return [...bands.values()].map((band) => html`<span style=${this.at(band.start, band.frames)} title=${band.title}>${band.title}</span>`);
  }

  private bar(shot: Placed, here: Placed | undefined) {
    const picture = this.board.scenes.flatMap((scene) => scene.shots).find((card) => card.shot === shot.shot)?.picture;
    const seconds = (shot.frames / this.cut!.fps).toFixed(1);
    return html`<div role="listitem" class="bar ${shot === here ? "here" : ""} ${this.selected.includes(shot.shot) ? "chosen" : ""}"
      style=${this.at(shot.start, shot.frames)} data-bar=${shot.shot} draggable="true"
      @dragstart=${() => (this.dragged = shot.shot)} @dragend=${() => (this.dragged = "")}
      @dragover=${(event: DragEvent) => this.dragged && event.preventDefault()} @drop=${() => this.drop(shot)}>
      <button class="face" aria-label="${shot.shot}, ${seconds} seconds" @click=${() => this.select(shot)}
        style=${picture ? `background-image: url("${picture}")` : ""}><b>${shot.shot.slice(-5)}</b> ${seconds} s</button>
      ${shot.fixed ? nothing : html`<span class="edge" aria-hidden="true" @pointerdown=${(event: PointerEvent) => this.grab(event, shot)}></span>`}
    </div>`;
  }
}
