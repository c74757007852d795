/** The cut: the film played from its frames, over a timeline on which shots are trimmed, moved and left out. */

import { LitElement, html, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { placed, shotAt, speechAt, timecode, type Placed } from "./cut_times";
import type { Board, Cut, Edit } from "./messages";
import type { Wire } from "./wire";

/** Fewest frames that a shot is trimmed to. */
const LEAST = 6;
const LOCK = html`<svg class="lock" viewBox="0 0 12 14" aria-hidden="true"><path d="M3.4 6V4a2.6 2.6 0 0 1 5.2 0v2" fill="none" stroke="currentColor" stroke-width="1.6" />
  <rect x="1.5" y="6" width="9" height="7" rx="1.2" fill="currentColor" /></svg>`;

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

  /** Say why something cannot be done. */
  private refuse(why: string): void {
    this.dispatchEvent(new CustomEvent("refuse", { detail: why }));
  }

  private resize(shot: Placed, frames: number): void {
    const wanted = Math.max(shot.frames + frames, LEAST);
    if (shot.held) this.refuse(shot.held);
    else if (wanted === shot.frames) this.refuse(`${shot.shot} has ${LEAST} frames; a shorter one is not made here`);
    else void this.edit({ kind: "duration", shot: shot.shot, frames: wanted });
  }

  /** Move a shot by one place in its scene. */
  private shift(shot: Placed, by: number): void {
    const other = this.shots[this.shots.indexOf(shot) + by];
    if (other?.scene === shot.scene) this.move(shot.shot, other.shot, by > 0);
    else this.refuse(`${shot.shot} is the ${by > 0 ? "last" : "first"} shot of ${shot.scene}; a shot stays in its scene`);
  }

  private move(shot: string, other: string, after: boolean): void {
    void this.edit({ kind: "reorder", target: shot, [after ? "after" : "before"]: other });
  }

  private drop(onto: Placed): void {
    const own = this.shots.find((shot) => shot.shot === this.dragged);
    if (own && own !== onto && own.scene === onto.scene) this.move(own.shot, onto.shot, own.start < onto.start);
    else if (own && own !== onto) this.refuse(`${own.shot} stays in ${own.scene}: a shot is moved within its scene`);
    this.dragged = "";
  }

  /** The end of a shot follows the pointer, and all that is after it; Escape gives it up. */
  private grab(event: PointerEvent, shot: Placed): void {
    event.preventDefault();
    event.stopPropagation();
    if (shot.held) return this.refuse(shot.held);
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

  /** Leave the cut for the shot's inspector. */
  private open(shot: Placed): void {
    this.select(shot);
    this.dispatchEvent(new CustomEvent("goto"));
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
    return html`
      <button title=${here.held} @click=${() => this.resize(here, -Math.round(fps / 2))}>Shorter</button>
      <button title=${here.held} @click=${() => this.resize(here, Math.round(fps / 2))}>Longer</button>
      <button @click=${() => this.shift(here, -1)}>Earlier</button>
      <button @click=${() => this.shift(here, 1)}>Later</button>
      <button @click=${() => this.edit({ kind: "omit", target: here.shot })}>Omit</button>
      <button title="Its camera, takes, notes and locks" @click=${() => this.open(here)}>Open ${here.shot.slice(-5)}</button>`;
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
    const card = this.board.scenes.flatMap((scene) => scene.shots).find((each) => each.shot === shot.shot);
    const seconds = (shot.frames / this.cut!.fps).toFixed(1);
    return html`<div role="listitem" class="bar ${shot === here ? "here" : ""} ${this.selected.includes(shot.shot) ? "chosen" : ""}"
      style=${this.at(shot.start, shot.frames)} data-bar=${shot.shot} draggable="true"
      @dragstart=${() => (this.dragged = shot.shot)} @dragend=${() => (this.dragged = "")}
      @dragover=${(event: DragEvent) => this.dragged && event.preventDefault()} @drop=${() => this.drop(shot)}>
      <button class="face" aria-label="${shot.shot}, ${seconds} seconds${shot.held ? ", not to be trimmed" : ""}" title=${shot.held} @click=${() => this.select(shot)}
        style=${card?.picture ? `background-image: url("${card.picture}")` : ""}><b>${shot.shot.slice(-5)}</b> ${seconds} s</button>
      ${shot.held && card?.locked ? LOCK : nothing}
      <span class="edge ${shot.held ? "held" : ""}" aria-hidden="true" title=${shot.held} @pointerdown=${(event: PointerEvent) => this.grab(event, shot)}></span>
    </div>`;
  }
}
