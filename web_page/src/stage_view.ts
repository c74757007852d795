/** The stage view: the scene of a shot in 3D, through its camera, freely, or from above. */

import { LitElement, html, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { Board, Edit, Point, Stage } from "./messages";
import "./stage_pose";
import { StageScene, type Moved, type View } from "./stage_scene";
import type { Wire } from "./wire";

const VIEWS: [View, string][] = [["shot", "Through the camera"], ["free", "Free"], ["plan", "From above"]];
const TURN = 15;
const NUDGE: Record<string, [number, number]> = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };

@customElement("sb-stage")
export class StageView extends LitElement {
  @property({ attribute: false }) board!: Board;
  @property({ attribute: false }) shot = "";
  @property({ attribute: false }) wire!: Wire;
  @state() private stage: Stage | null = null;
  @state() private view: View = "shot";
  @state() private frame = 0;
  @state() private chosen = "";
  /** Whose pose is shown: who was chosen as the pointer was let go, so that nothing shifts below a drag. */
  @state() private posed = "";
  @state() private guides = true;
  @state() private why = "";
  @query("canvas") private canvas!: HTMLCanvasElement;
  @query(".room") private room!: HTMLElement;
  private asked = 0;
  /** Whether the scene is still being asked for. */
  busy = false;
  scene: StageScene | null = null;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  private released = () => (this.posed = this.chosen);

  connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener("pointerup", this.released);
  }

  private resized = new ResizeObserver(() => this.fit());

  protected firstUpdated(): void {
    this.scene = new StageScene(this.canvas, {
      chose: (node) => (this.chosen = node),
      moved: (moved) => this.moved(moved),
    });
    this.resized.observe(this.room);
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

  /** Ask for the scene at a moment; only the last answer counts. */
  private async ask(frame: number | null): Promise<void> {
    const asked = ++this.asked;
    this.busy = true;
    try {
      const stage = await this.wire.call<Stage>("stage", { shot: this.shot, frame });
      if (asked !== this.asked) return;
      await this.scene!.show(stage);
      [this.stage, this.frame, this.why] = [stage, stage.frame, ""];
      this.fit();
    } catch (error) {
      if (asked === this.asked) this.why = (error as Error).message;
    }
    if (asked === this.asked) this.busy = false;
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

  /** Make an edit; if it is refused, what was moved goes back. */
  private async edit(edit: Edit): Promise<void> {
    const done = new Promise<boolean>((settled) => this.dispatchEvent(new CustomEvent("edit", { detail: { edits: [edit], settled } })));
    if (!(await done)) await this.scene?.putBack();
  }

  private place(thing: string, place: Record<string, unknown>): Promise<void> {
    return this.edit({ kind: "place", scene: this.shot.slice(0, -6), thing, place });
  }

  /** Of a person who goes somewhere, the mark that is nearer in time is moved. */
  private moved({ node, by }: Moved): Promise<void> {
    const { placed, people, frames } = this.stage!;
    const shifted = ([x, y]: Point) => ({ location: [round(x + by.x), round(y + by.y)] });
    if (node in placed) return this.place(node, shifted(placed[node].location));
    const { start, end } = people[node];
    const goes = Math.hypot(end[0] - start[0], end[1] - start[1]) > 0.05;
    const marks = goes && this.frame > frames / 2 ? { end: shifted(end) } : { start: shifted(start) };
    return this.edit({ kind: "blocking", shot: this.shot, person: node, marks });
  }

  private turn(degrees: number): void {
    if (!this.stage) return;
    const { placed, people } = this.stage;
    const rotation = round((placed[this.chosen]?.rotation ?? people[this.chosen]?.rotation ?? 0) + degrees);
    if (this.chosen in placed) void this.place(this.chosen, { rotation });
    else if (this.chosen in people) void this.edit({ kind: "blocking", shot: this.shot, person: this.chosen, marks: { start: { rotation } } });
    else return;
    this.scene!.turn(this.chosen, degrees);
  }

  /** The shot is taken from where the free view is. */
  private shoot(): Promise<void> {
    const { location, target, lens } = this.scene!.freePose;
    this.look("shot");
    return this.edit({ kind: "camera", shot: this.shot, decision: { placed: { start: { location, target } }, lens } });
  }

  private keys(event: KeyboardEvent): void {
    const movable = this.chosen in (this.stage?.placed ?? {}) || this.chosen in (this.stage?.people ?? {});
    if (event.key === "Escape" && this.scene?.cancel()) {
      event.stopPropagation();
    } else if (event.key === "[" || event.key === "]") {
      this.turn(event.key === "[" ? TURN : -TURN);
    } else if (movable && this.view !== "shot" && event.key in NUDGE) {
      event.preventDefault();
      const [x, y] = NUDGE[event.key];
      void this.moved({ node: this.chosen, by: { x, y } });
    }
  }

  render() {
    const found = this.stage?.placed[this.chosen] ?? this.stage?.people[this.chosen];
    return html`
      <section class="stage" aria-label="Stage" @keydown=${(event: KeyboardEvent) => this.keys(event)}>
        <div class="bar tools" role="toolbar" aria-label="View">
          ${VIEWS.map(([view, label]) => html`<button aria-pressed=${this.view === view} class=${this.view === view ? "chosen" : ""}
            @click=${() => this.look(view)}>${label}</button>`)}
          <label><input type="checkbox" .checked=${this.guides} @change=${() => (this.guides = !this.guides)} /> Guides</label>
          ${this.view === "free" ? html`<button @click=${() => this.shoot()}>Shoot from here</button>` : nothing}
          <span class="space"></span>
          ${this.chosen ? html`<b>${found?.name ?? this.chosen}</b>` : nothing}
          ${found
            ? html`<button title="Turn left ( [ )" @click=${() => this.turn(TURN)}>⟲ ${TURN}°</button>
                <button title="Turn right ( ] )" @click=${() => this.turn(-TURN)}>⟳ ${TURN}°</button>`
            : nothing}
        </div>
        ${this.stage && this.posed in this.stage.people
          ? html`<sb-pose .stage=${this.stage} .person=${this.posed} .frame=${this.frame} .wire=${this.wire} @pose=${(event: CustomEvent<Edit>) => this.edit(event.detail)}></sb-pose>`
          : nothing}
        <div class="room">
          <div class="frame">
            <canvas tabindex="0" role="img" aria-label="The scene in 3D"></canvas>
            ${this.guides && this.view === "shot" && this.stage ? html`<div class="thirds" aria-hidden="true"></div>` : nothing}
          </div>
          ${this.stage ? nothing : html`<p class="wait">${this.why || "Setting the stage ..."}</p>`}
        </div>
        ${this.stage
          ? html`<label class="scrub">Moment <input type="range" min="0" max=${this.stage.frames - 1} .value=${String(this.frame)}
              @input=${(event: Event) => this.scene?.seek((this.frame = Number((event.target as HTMLInputElement).value)))}
              @change=${() => this.ask(this.frame)} /> ${(this.frame / this.stage.fps).toFixed(1)} s</label>`
          : nothing}
        <div class="strip">${this.board.scenes
          .filter((scene) => this.shot.startsWith(scene.scene))
          .flatMap((scene) => scene.shots)
          .map((card) => html`<button class=${card.shot === this.shot ? "chosen" : ""} aria-label=${card.shot}
            @click=${() => this.dispatchEvent(new CustomEvent("select", { detail: [card.shot] }))}>
            ${card.picture ? html`<img src=${card.picture} alt="" style="aspect-ratio: ${this.board.aspect}" />` : nothing}
            <span>${card.shot.slice(-5)}</span></button>`)}</div>
      </section>`;
  }
}

/** Metres to the millimetre, degrees to a thousandth. */
function round(value: number): number {
  return Math.round(value * 1000) / 1000;
}
