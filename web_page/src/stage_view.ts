/** The stage view: the scene of a shot in 3D, through its camera, freely, or from above. */

import { LitElement, html, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { Board, Edit } from "./messages";
import type { Done, Tool } from "./stage_hands";
import { editOf, marksEdit, nameOf, partsOf, put, shotFrom, spotOf, turnOf } from "./stage_items";
import "./stage_numbers";
import "./stage_pose";
import { StageScene, type View } from "./stage_scene";
import type { Point, Stage } from "./stage_values";
import type { Wire } from "./wire";

const VIEWS: [View, string][] = [["shot", "Through the camera"], ["free", "Free"], ["plan", "From above"]];
const TOOLS: [Tool, string, string][] = [["move", "Move", "G or W"], ["turn", "Turn", "R or E"], ["scale", "Scale", "S"]];
const TOOL_KEYS: Record<string, Tool> = { g: "move", w: "move", r: "turn", e: "turn", s: "scale" };
const VIEW_KEYS: Record<string, View> = { "1": "shot", "2": "free", "3": "plan" };
const TURN = 15;
const NUDGE: Record<string, [number, number, number]> = {
  ArrowLeft: [-0.1, 0, 0], ArrowRight: [0.1, 0, 0], ArrowUp: [0, 0.1, 0], ArrowDown: [0, -0.1, 0], PageUp: [0, 0, 0.1], PageDown: [0, 0, -0.1],
};

@customElement("sb-stage")
export class StageView extends LitElement {
  @property({ attribute: false }) board!: Board;
  @property({ attribute: false }) shot = "";
  @property({ attribute: false }) wire!: Wire;
  @state() private stage: Stage | null = null;
  @state() private view: View = "shot";
  @state() private tool: Tool = "move";
  @state() private frame = 0;
  @state() private chosen = "";
  /** What the rows above the picture are about: what was chosen as the pointer was let go, so that nothing shifts below a drag. */
  @state() private shown = "";
  @state() private guides = true;
  @state() private why = "";
  @state() private lost = false;
  @state() private changes = 0;
  @query("canvas") private canvas!: HTMLCanvasElement;
  @query(".room") private room!: HTMLElement;
  private asked = 0;
  /** Edits under way; until they are answered, what was moved stays where the hand put it. */
  private editing = 0;
  /** Whether the scene is still being asked for. */
  busy = false;
  scene: StageScene | null = null;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  private released = () => (this.shown = this.chosen);

  connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener("pointerup", this.released);
  }

  private resized = new ResizeObserver(() => this.fit());

  protected firstUpdated(): void {
    this.scene = new StageScene(this.canvas, {
      chose: (item) => (this.chosen = item),
      done: (done) => void this.done(done),
      changed: () => this.changes++,
    });
    this.canvas.addEventListener("webglcontextlost", () => (this.lost = true));
    this.canvas.addEventListener("webglcontextrestored", () => (this.lost = false));
    this.resized.observe(this.room);
    if (!document.activeElement?.closest("input, textarea, select")) this.canvas.focus(); // its keys are heard there
  }

  disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener("pointerup", this.released);
    this.resized.disconnect();
    this.scene?.dispose();
  }

  protected updated(changed: PropertyValues<this>): void {
    if (changed.has("shot")) void this.ask(null);
    else if (changed.has("board") && changed.get("board")?.revision !== this.board.revision) void this.ask(this.frame);
  }

  /** Ask for the scene at a moment; only the last answer counts, and what a hand has moved since stays. */
  private async ask(frame: number | null): Promise<void> {
    const asked = ++this.asked;
    const wanted = () => asked === this.asked && !this.editing;
    this.busy = true;
    try {
      const stage = await this.wire.call<Stage>("stage", { shot: this.shot, frame });
      if (!wanted()) return;
      await this.scene!.show(stage, wanted);
      if (!wanted()) return;
      [this.stage, this.frame, this.why] = [stage, stage.frame, ""];
      [this.chosen, this.shown] = [this.scene!.chosen, this.scene!.chosen];
      this.fit();
    } catch (error) {
      if (asked === this.asked) this.why = `The scene cannot be shown: ${(error as Error).message}`;
    } finally {
      if (asked === this.asked) this.busy = false;
    }
  }

  /** The canvas fills the room; through the camera it has the shape of the picture. */
  private fit(): void {
    if (!this.scene) return;
    const { clientWidth: wide, clientHeight: high } = this.room;
    const aspect = this.view === "shot" ? (this.stage?.aspect ?? this.board.aspect) : wide / high;
    const width = Math.min(wide, high * aspect);
    this.canvas.parentElement!.style.width = `${width}px`;
    this.canvas.parentElement!.style.height = `${width / aspect}px`;
    this.scene.resize(width, width / aspect);
  }

  private look(view: View): void {
    this.view = view;
    this.scene?.look(view);
    this.fit();
  }

  private take(tool: Tool): void {
    this.tool = this.scene!.tool = tool;
  }

  /** Make edits, as one; if they are refused, what was moved goes back. */
  private async edit(edits: Edit[]): Promise<void> {
    this.editing++;
    const done = await new Promise<boolean>((settled) => this.dispatchEvent(new CustomEvent("edit", { detail: { edits, settled } })));
    this.editing--;
    if (!done) await this.scene?.putBack();
    if (!done && !this.editing) void this.ask(this.frame);
  }

  private get draft(): Stage {
    return this.scene!.stage!;
  }

  /** What a hand has done becomes an edit. */
  private done({ item, tool, turned, scale, lifted }: Done): Promise<void> {
    if (tool === "turn") return this.turned(item, turned);
    const scene = this.shot.slice(0, -6);
    if (tool === "scale") return this.edit([{ kind: "place", scene, thing: item, scale: Math.round(scale * 1000) / 1000 }]);
    return this.edit([editOf(this.draft, item, lifted)]);
  }

  /** An item that is turned already stays so. */
  private turned(item: string, degrees: number): Promise<void> {
    const rotation = Math.round((turnOf(this.draft, item) ?? 0) * 1000) / 1000;
    const scene = this.shot.slice(0, -6);
    if (!degrees) return Promise.resolve();
    if (item in this.draft.placed) return this.edit([{ kind: "place", scene, thing: item, place: { rotation } }]);
    return this.edit([marksEdit(this.draft, item, { start: { rotation } })]);
  }

  private turn(degrees: number): void {
    if (turnOf(this.draft, this.chosen) === null) return;
    this.scene!.turn(this.chosen, degrees);
    void this.turned(this.chosen, degrees);
  }

  /** Move what is chosen by a key. */
  private nudge(by: [number, number, number]): void {
    const spot = spotOf(this.draft, this.chosen);
    if (!spot) return;
    put(this.draft, this.chosen, spot.map((value, axis) => value + by[axis]) as Point);
    this.scene!.shifted(this.chosen, by);
    this.changes++;
    void this.edit([editOf(this.draft, this.chosen, by[2] !== 0)]);
  }

  private keys(event: KeyboardEvent): void {
    const typing = (event.target as HTMLElement).closest("input, select");
    if (event.key === "Escape" && this.scene?.cancel()) return event.stopPropagation();
    if (typing || !this.scene?.stage) return;
    const key = event.key.toLowerCase();
    const button = (does: string) => this.querySelector<HTMLButtonElement>(`[data-does=${does}]`);
    const held = event.ctrlKey || event.metaKey || event.altKey;
    const acts: Record<string, () => void> = {
      "[": () => this.turn(TURN), "]": () => this.turn(-TURN), f: () => this.scene!.focusChosen(), delete: () => button("remove")?.click(),
      b: () => button("drop")?.click(),
    };
    const act =
      held ? (key === "d" ? () => button("copy")?.click() : undefined)
      : event.key in NUDGE && this.view !== "shot" ? () => this.nudge(NUDGE[event.key])
      : key in TOOL_KEYS ? () => this.take(TOOL_KEYS[key])
      : key in VIEW_KEYS ? () => this.look(VIEW_KEYS[key])
      : acts[key];
    if (!act) return;
    event.preventDefault();
    event.stopPropagation();
    act();
  }

  render() {
    return html`
      <section class="stage" aria-label="Stage" @keydown=${(event: KeyboardEvent) => this.keys(event)}>
        <div class="bar tools" role="toolbar" aria-label="View">
          ${VIEWS.map(([view, label], index) => html`<button aria-pressed=${this.view === view} class=${this.view === view ? "chosen" : ""} title="Key ${index + 1}"
            @click=${() => this.look(view)}>${label}</button>`)}
          <label><input type="checkbox" .checked=${this.guides} @change=${() => (this.guides = !this.guides)} /> Guides</label>
          ${this.view === "free" && this.stage ? this.shoot() : nothing}
          <span class="space"></span>
          ${this.stage && this.shown ? html`<b>${nameOf(this.stage, this.shown)}</b>` : nothing}
          ${TOOLS.map(([tool, label, key]) => html`<button aria-pressed=${this.tool === tool} class=${this.tool === tool ? "chosen" : ""} title="Key ${key}"
            @click=${() => this.take(tool)}>${label}</button>`)}
        </div>
        ${this.stage ? this.rows(this.stage) : nothing}
        <div class="room">
          ${this.why && this.stage ? html`<p class="bar wrong" role="alert">${this.why} <button @click=${() => this.ask(this.frame)}>Try again</button></p>` : nothing}
          <div class="frame">
            <canvas tabindex="0" role="img" aria-label="The scene in 3D${this.chosen && this.stage ? `, ${nameOf(this.stage, this.chosen)} chosen` : ""}"></canvas>
            ${this.guides && this.view === "shot" && this.stage ? html`<div class="thirds" aria-hidden="true"></div>` : nothing}
          </div>
          ${this.stage && !this.lost ? nothing : html`<p class="wait" role="status">${this.lost ? "The graphics are coming back ..." : this.why || "Setting the stage ..."}</p>`}
        </div>
        ${this.stage
          ? html`<label class="scrub">Moment <input type="range" min="0" max=${this.stage.frames - 1} .value=${String(this.frame)}
              @input=${(event: Event) => this.scene?.seek((this.frame = Number((event.target as HTMLInputElement).value)))}
              @change=${() => this.ask(this.frame)} /> ${(this.frame / this.stage.fps).toFixed(1)} s</label>`
          : nothing}
        ${this.strip()}
      </section>`;
  }

  /** The shot is taken from where the free view is. */
  private shoot() {
    const from = (when: "start" | "end" | "always") => {
      const edit = shotFrom(this.draft, this.scene!.freePose, when);
      if (when === "always") this.look("shot");
      return this.edit([edit]);
    };
    return html`<button @click=${() => from("always")}>Shoot from here</button>
      <button title="The camera begins a move here" @click=${() => from("start")}>Begin here</button>
      <button title="The camera ends a move here" @click=${() => from("end")}>End here</button>`;
  }

  /** What is chosen, exactly, and the pose of a person. */
  private rows(stage: Stage) {
    const draft = this.scene?.stage ?? stage;
    const [, id] = partsOf(this.shown);
    const make = (event: CustomEvent<Edit[]>) => this.edit(event.detail);
    return html`<sb-numbers .stage=${draft} .item=${this.shown} .change=${this.changes} .board=${this.board} @make=${make}
        @go=${(event: CustomEvent<string>) => this.dispatchEvent(new CustomEvent("select", { detail: [event.detail] }))}></sb-numbers>
      ${this.shown === id && id in stage.people
        ? html`<sb-pose .stage=${stage} .person=${id} .frame=${this.frame} .wire=${this.wire} @pose=${(event: CustomEvent<Edit>) => this.edit([event.detail])}></sb-pose>`
        : nothing}`;
  }

  private strip() {
    return html`<div class="strip">${this.board.scenes
      .filter((scene) => this.shot.startsWith(scene.scene))
      .flatMap((scene) => scene.shots)
      .map((card) => html`<button class=${card.shot === this.shot ? "chosen" : ""} aria-label=${card.shot}
        @click=${() => this.dispatchEvent(new CustomEvent("select", { detail: [card.shot] }))}>
        ${card.picture ? html`<img src=${card.picture} alt="" style="aspect-ratio: ${this.board.aspect}" />` : nothing}
        <span>${card.shot.slice(-5)}</span></button>`)}</div>`;
  }
}
