/** What is chosen on the stage in numbers: its exact place, turn and size; a lamp's light; a camera's lens and focus. */

import { LitElement, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import { lensesOf, STOPS } from "./camera_kit";
import { hex, linear } from "./colors";
import type { Board, Edit } from "./messages";
import { poseOf, roundTo } from "./stage_cameras";
import { cameraEdit, cameraOf, editOf, lampEdit, marksEdit, nameOf, partsOf, put, putCamera, spotOf } from "./stage_items";
import { numberField } from "./number_field";
import type { LampOnStage, PersonOnStage, PlacedThing, Point, Stage, StageCamera } from "./stage_values";

const AXES = ["X", "Y", "Z"];

@customElement("sb-numbers")
export class StageNumbers extends LitElement {
  @property({ attribute: false }) stage!: Stage;
  /** The item that is chosen; the camera of the shot where nothing is. */
  @property({ attribute: false }) item = "";
  /** Another one for each change of the stage. */
  @property({ type: Number }) change = 0;
  @property({ attribute: false }) board!: Board;

  protected createRenderRoot(): HTMLElement {
    return this;
  }

  private make(...edits: Edit[]): void {
    this.dispatchEvent(new CustomEvent("make", { detail: edits }));
  }

  render() {
    const item = nameOf(this.stage, this.item) ? this.item : `camera:${this.stage.shot}:start`;
    const [kind, id] = partsOf(item);
    const shown = this.shown(item, kind, id);
    return html`<div class="bar numbers" role="group" aria-label="Exactly">${shown}</div>`;
  }

  private shown(item: string, kind: string, id: string) {
    const { placed, people, lamps } = this.stage;
    if (kind === "node" && id in placed) return this.thing(id, placed[id]);
    if (kind === "node" && id in people) return this.person(id, people[id]);
    if (kind === "lamp" || kind === "lamp-aim") return this.lamp(id, lamps[id]);
    if (kind === "mark" || kind === "via") return this.mark(item, kind, id);
    const camera = cameraOf(this.stage, id);
    return camera ? this.camera(camera) : nothing;
  }

  private number(label: string, value: number, changed: (value: number) => void, step = 0.1, least = -1000, most = 1000) {
    return numberField(label, roundTo(value, 3), changed, step, least, most);
  }

  /** Fields of a place in the scene, and the edit that puts the item there. */
  private place(item: string, axes = 3, height = false) {
    const spot = spotOf(this.stage, item)!;
    return AXES.slice(0, axes).map((axis, index) => this.number(axis, spot[index], (value) => {
      const to = [...spot] as Point;
      to[index] = value;
      const stage = structuredClone(this.stage);
      put(stage, item, to);
      this.make(editOf(stage, item, height || index === 2));
    }));
  }

  private thing(id: string, thing: PlacedThing) {
    const scene = this.stage.shot.slice(0, -6);
    const place = (decided: object) => this.make({ kind: "place", scene, thing: id, ...decided });
    const [x, y, z] = thing.location;
    const second = { location: [roundTo(x + 0.5, 3), y], rotation: thing.rotation, ...(thing.rests === "hangs" ? { height: z } : {}) };
    return html`${this.place(id)}
      ${this.number("Turn", thing.rotation, (rotation) => place({ place: { rotation } }), 5)}
      ${this.number("Size %", 100, (value) => place({ scale: value / 100 }), 10, 2, 5000)}
      <button title="Put it on what is below (B)" data-does="drop" @click=${() => place({ place: { location: [x, y] } })}>Drop</button>
      <button title="One more of it (Ctrl+D)" ?disabled=${!thing.model} data-does="copy"
        @click=${() => this.make({ kind: "asset", action: "add", scene, model: thing.model, place: second })}>One more</button>
      <button title="Take it away (Delete)" data-does="remove"
        @click=${() => this.make({ kind: "asset", action: "remove", scene, thing: id })}>Take away</button>`;
  }

  private person(id: string, person: PersonOnStage) {
    return html`<span>begins</span>${this.place(`mark:${id}:start`, 2)}
      ${this.number("Turn", person.rotation, (rotation) => this.make(marksEdit(this.stage, id, { start: { rotation } })), 5)}
      <span>ends</span>${this.place(`mark:${id}:end`, 2)}
      ${person.via.length ? html`<button @click=${() => this.make(marksEdit(this.stage, id, { via: [] }))}>Free the way</button>` : nothing}`;
  }

  private mark(item: string, kind: string, id: string) {
    const { via } = this.stage.people[id];
    const rest = via.filter((_, index) => item !== `via:${id}:${index}`);
    return html`${this.place(item, 2)}
      ${kind === "via" ? html`<button title="Delete" data-does="remove" @click=${() => this.make(marksEdit(this.stage, id, { via: rest }))}>Take away</button>` : nothing}`;
  }

  private lamp(id: string, lamp: LampOnStage) {
    const decide = (decided: object | null) => this.make(lampEdit(this.stage, id, decided));
    return html`${this.place(`lamp:${id}`)}<span>points at</span>${this.place(`lamp-aim:${id}`)}
      ${this.number("Power", lamp.power, (power) => decide({ power }), 5, 0, 100_000)}
      <label>Colour <input type="color" .value=${hex(lamp.color)} @change=${(event: Event) => decide({ color: linear((event.target as HTMLInputElement).value) })} /></label>
      <button title="Delete" data-does="remove" @click=${() => decide(null)}>Take away</button>`;
  }

  private camera(camera: StageCamera) {
    const decide = (decision: object) => this.make({ kind: "camera", shot: camera.shot, decision });
    const lens = roundTo(camera.keys[0].lens, 1);
    const when = partsOf(this.item)[2] === "end" ? "end" : "start";
    const pose = poseOf(camera, when);
    return html`<b>Camera ${camera.shot.slice(-5)}</b>
      ${this.choice("Lens", lens, lensesOf(this.board), (value) => `${value} mm`, (value) => decide({ lens: value }))}
      ${this.choice("Aperture", camera.f_number, STOPS, (value) => `f/${value}`, (value) => decide({ f_number: value }))}
      ${this.sharp("Focus", camera.focus[0], (focus) => decide({ focus }))}
      ${this.sharp("then", camera.focus[1], (focus_to) => decide({ focus_to }))}
      ${this.number("Lean", pose.roll, (roll) => {
        const stage = structuredClone(this.stage);
        putCamera(stage, camera.shot, when, { roll });
        this.make(cameraEdit(stage, camera.shot));
      }, 1, -180, 180)}
      ${partsOf(this.item)[0] === "camera" ? this.place(`camera:${camera.shot}:${when}`) : nothing}
      ${partsOf(this.item)[0] === "aim" ? this.place(`aim:${camera.shot}:${when}`) : nothing}
      ${camera.shot === this.stage.shot ? nothing : html`<button @click=${() =>
        this.dispatchEvent(new CustomEvent("go", { detail: camera.shot }))}>Go to it</button>`}
      ${this.film()}`;
  }

  /** The picture of the whole film: its shape, and the sensor behind every lens. */
  private film() {
    const { aspect, aspects, sensor_width, sensors } = this.board;
    const decide = (decision: object) => this.make({ kind: "format", decision });
    const called = (all: Record<string, number>, value: number) => Object.keys(all).find((name) => all[name] === value);
    return html`<span class="film" role="group" aria-label="The whole film" title="Of the whole film: every camera that is not locked is set for it anew">
      ${this.choice("Picture", aspect, Object.values(aspects), (value) => called(aspects, value) ?? `${roundTo(value, 3)}:1`, (value) => decide({ aspect: value }))}
      ${this.choice("Sensor", sensor_width, Object.values(sensors), (value) => `${called(sensors, value) ?? ""} ${roundTo(value, 2)} mm`, (value) => decide({ sensor_width: value }))}</span>`;
  }

  private choice(label: string, now: number, all: number[], told: (value: number) => string, chosen: (value: number) => void) {
    const values = [...new Set([...all, now])].sort((one, other) => one - other);
    return html`<label>${label} <select @change=${(event: Event) => chosen(Number((event.target as HTMLSelectElement).value))}>
      ${values.map((value) => html`<option value=${value} ?selected=${value === now}>${told(value)}</option>`)}</select></label>`;
  }

  private sharp(label: string, now: string | undefined, chosen: (id: string) => void) {
    const names = this.stage.poses.look;
    return html`<label>${label} <select aria-label=${label === "then" ? "Focus at the end" : label}
      @change=${(event: Event) => chosen((event.target as HTMLSelectElement).value)}>
      ${now && now in names ? nothing : html`<option selected disabled value="">${label === "then" ? "the same" : "the crew's choice"}</option>`}
      ${Object.entries(names).map(([id, name]) => html`<option value=${id} ?selected=${id === now}>${name}</option>`)}</select></label>`;
  }
}
