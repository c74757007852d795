/** The stage: a scene in 3D in Blender's coordinates (metres, Z up), seen through a shot, freely, or from above. */

import {
  Box3, Color, DirectionalLight, Group, HemisphereLight, Matrix4, OrthographicCamera, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { type CameraPose, keyAt, look, poseOf, worldOf } from "./stage_cameras";
import { inTheWay } from "./stage_cutaway";
import { type Done, StageHands, type Tool, turn } from "./stage_hands";
import { cameraOf, nameOf, noteWhere, partsOf, spotOf, turnOf } from "./stage_items";
import { StageModel } from "./stage_model";
import { clear, overlay, ring } from "./stage_overlay";
import type { FloorPoint, Point, Stage } from "./stage_values";

export type View = "shot" | "free" | "plan";

const CHOSEN = 0x6fb1ff;
const HIT = 0xff5a4a;
/** Metres: what is above is cut off in the plan. */
const PLAN_HEIGHT = 2.3;
/** Pixels from a way at which it is taken hold of. */
const NEAR_WAY = 7;

export class StageScene {
  readonly scene = new Scene();
  readonly model = new StageModel();
  readonly hands = new StageHands(this.model);
  private renderer: WebGLRenderer;
  private shotCamera = new PerspectiveCamera(40, 16 / 9, 0.05, 1000);
  private freeCamera = new PerspectiveCamera(40, 16 / 9, 0.05, 1000);
  private planCamera = new OrthographicCamera(-5, 5, 5, -5, 0, 100);
  private free: OrbitControls;
  private plan: OrbitControls;
  private over = new Group();
  /** Metres that a pixel of the plan is wide before it is zoomed; 0 until it is drawn, then the same whatever its size. */
  private planScale = 0;
  private asked = 0;
  private drawing = 0;
  /** The stage with all that was moved by hand since the studio told it. */
  stage: Stage | null = null;
  private asTold: Stage | null = null;
  view: View = "shot";
  tool: Tool = "move";
  frame = 0;
  chosen = "";
  /** What the chosen one stood in when it was chosen, as a chair at its table; null until that is looked at. */
  private stood: string[] | null = null;

  constructor(
    private canvas: HTMLCanvasElement,
    private told: { chose(item: string): void; done(done: Done): void; changed(): void },
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.scene.background = new Color(0x2a2d33);
    const sun = new DirectionalLight(0xffffff, 1.6);
    sun.position.set(3, -6, 9);
    this.scene.add(new HemisphereLight(0xffffff, 0x8a7f70, 2.0), sun, this.model.root, this.over);
    this.freeCamera.up.set(0, 0, 1);
    this.planCamera.up.set(0, 1, 0);
    this.free = new OrbitControls(this.freeCamera, canvas);
    this.plan = new OrbitControls(this.planCamera, canvas);
    this.plan.enableRotate = false;
    for (const controls of [this.free, this.plan]) controls.addEventListener("change", () => this.draw());
    canvas.addEventListener("pointerdown", (event) => this.press(event), { capture: true });
    canvas.addEventListener("pointermove", (event) => this.pull(event));
    canvas.addEventListener("pointerup", () => this.release());
    canvas.addEventListener("pointercancel", () => this.cancel());
    canvas.addEventListener("webglcontextrestored", () => this.draw());
    this.switchControls();
  }

  dispose(): void {
    cancelAnimationFrame(this.drawing);
    this.free.dispose();
    this.plan.dispose();
    this.renderer.dispose();
  }

  /**
   * Show a stage once nothing is held; the model is loaded unless it is shown already. What was moved by hand is replaced.
   * @param wanted Whether it is still to be shown when it is there.
   */
  async show(stage: Stage, wanted = () => true): Promise<void> {
    const [before, asked] = [this.asTold, ++this.asked];
    const loaded = before?.model !== stage.model ? await this.model.load(stage.model) : null;
    while (this.hands.item) await new Promise((frame) => requestAnimationFrame(frame));
    if (asked !== this.asked || !wanted()) return;
    if (loaded) this.model.stand(loaded);
    const cameras = this.stage?.cameras.filter((camera) => stage.setting.includes(camera.shot)) ?? [];
    [this.asTold, this.stage, this.frame] = [stage, structuredClone(stage), stage.frame];
    this.stage.cameras.push(...cameras); // those that the crew is setting stay as they were until it has
    for (const person of Object.keys(stage.people)) {
      const { x, y } = this.model.box(person).getCenter(new Vector3());
      noteWhere(this.stage, person, x, y);
    }
    if (before?.shot.slice(0, 5) !== stage.shot.slice(0, 5)) this.frameAll();
    if (before?.shot !== stage.shot) this.startFree();
    if (before?.shot !== stage.shot || before.frame !== stage.frame) this.stood = null;
    this.choose(nameOf(stage, this.chosen) ? this.chosen : "");
  }

  /** Show everything as the studio told it, whatever was moved by hand. */
  async putBack(): Promise<void> {
    const told = this.asTold;
    if (!told) return;
    this.asTold = { ...told, model: "" };
    await this.show(told);
  }

  look(view: View): void {
    this.view = view;
    this.switchControls();
    this.draw();
  }

  seek(frame: number): void {
    this.frame = frame;
    if (this.stage) this.stage.frame = frame;
    this.draw();
  }

  choose(item: string): void {
    if (item !== this.chosen) this.stood = null;
    this.chosen = item;
    this.draw();
  }

  /** Turn a thing or a person where they stand, until the studio has turned them. */
  turn(node: string, degrees: number): void {
    if (!this.stage) return;
    this.model.settle();
    turn(this.stage, this.model, [node, ...(this.stage.placed[node]?.carries ?? [])], node, (turnOf(this.stage, node) ?? 0) + degrees, degrees);
    this.draw();
  }

  /** Show a thing or a person elsewhere, until the studio has put them there. */
  shifted(node: string, by: Point): void {
    this.model.settle();
    this.model.move([node, ...(this.stage?.placed[node]?.carries ?? [])], new Matrix4().makeTranslation(...by));
    this.draw();
  }

  /** Look at what is chosen from nearby. */
  focusChosen(): void {
    const at = this.stage && spotOf(this.stage, this.chosen);
    if (!at) return;
    const box = this.model.has(this.chosen) ? this.model.box(this.chosen) : new Box3().setFromCenterAndSize(new Vector3(...at), new Vector3(1, 1, 1));
    const [middle, size] = [box.getCenter(new Vector3()), box.getSize(new Vector3()).length()];
    const away = this.freeCamera.position.clone().sub(this.free.target).setLength(Math.max(1.5, 1.8 * size));
    this.free.target.copy(middle);
    this.freeCamera.position.copy(middle).add(away);
    this.plan.target.set(middle.x, middle.y, 0);
    this.planCamera.position.set(middle.x, middle.y, PLAN_HEIGHT);
    this.planCamera.zoom = Math.max(1, Math.min(8, Math.max(...this.span) / (4 * size)));
    this.free.update();
    this.plan.update();
    this.draw();
  }

  resize(width: number, height: number): void {
    this.renderer.setSize(width, height, false);
    this.draw();
  }

  /** Where the free camera is, as an edit of the shot's camera takes it. */
  get freePose(): CameraPose {
    return { location: this.freeCamera.position.toArray(), target: this.free.target.toArray(), roll: 0 };
  }

  /** Where points of the scene are in the shot's picture: 0 to 1 from the left and from the top. */
  pictured(points: number[][]): number[][] {
    if (this.stage && this.camera) look(this.shotCamera, this.camera, this.frame, this.stage.aspect);
    return points.map((point) => this.seenAt(new Vector3(...(point as Point)), this.shotCamera));
  }

  /** Where the middle of an item is in the view: 0 to 1 from the left and from the top. */
  onScreen(item: string): number[] {
    const grip = this.over.getObjectByProperty("name", item);
    const at = grip ? grip.position : this.model.box(item).getCenter(new Vector3());
    return this.seenAt(at.clone(), this.active);
  }

  private seenAt(point: Vector3, camera: PerspectiveCamera | OrthographicCamera): number[] {
    const seen = point.project(camera);
    return [(seen.x + 1) / 2, (1 - seen.y) / 2];
  }

  private get camera() {
    return this.stage ? cameraOf(this.stage, this.stage.shot) : undefined;
  }

  private get active(): PerspectiveCamera | OrthographicCamera {
    return { shot: this.shotCamera, free: this.freeCamera, plan: this.planCamera }[this.view];
  }

  private get span(): [number, number] {
    return (this.planCamera.userData.span as [number, number] | undefined) ?? [10, 10];
  }

  private switchControls(): void {
    this.free.enabled = this.view === "free" && !this.hands.item;
    this.plan.enabled = this.view === "plan" && !this.hands.item;
  }

  /** The free camera begins where the shot's is. */
  private startFree(): void {
    if (!this.stage || !this.camera) return;
    look(this.freeCamera, this.camera, this.frame, this.stage.aspect);
    const key = keyAt(this.camera, this.frame);
    this.free.target.set(0, 0, -key.distance).applyMatrix4(worldOf(key));
    this.free.update();
  }

  /** The plan shows everything that the layout placed, and the cameras. */
  private frameAll(): void {
    const all = new Box3();
    for (const id of Object.keys(this.stage?.placed ?? {})) all.union(this.model.box(id));
    for (const camera of this.stage?.cameras ?? []) all.expandByPoint(new Vector3(...poseOf(camera, "start").location));
    if (all.isEmpty()) all.setFromObject(this.model.root);
    const [middle, size] = [all.getCenter(new Vector3()), all.getSize(new Vector3())];
    this.planCamera.position.set(middle.x, middle.y, PLAN_HEIGHT);
    this.plan.target.set(middle.x, middle.y, 0);
    [this.planCamera.zoom, this.planScale] = [1, 0];
    this.planCamera.userData.span = [size.x + 2, size.y + 2];
    this.plan.update();
  }

  /** Draw the next time that the browser draws. */
  draw(): void {
    this.drawing ||= requestAnimationFrame(() => {
      this.drawing = 0;
      if (this.stage) this.render(this.stage);
    });
  }

  private render(stage: Stage): void {
    const { width, height } = this.canvas;
    if (!width || !height) return; // the page is not laid out yet
    const shape = width / height;
    this.model.hide(this.hidden(stage));
    if (this.view === "shot" && this.camera) {
      look(this.shotCamera, this.camera, this.frame, stage.aspect);
    } else if (this.view === "free") {
      this.freeCamera.aspect = shape;
      this.freeCamera.updateProjectionMatrix();
    } else {
      const [across, along] = this.span;
      this.planScale ||= Math.max(along / this.canvas.clientHeight, across / this.canvas.clientWidth);
      const half = (this.planScale * this.canvas.clientHeight) / 2;
      Object.assign(this.planCamera, { left: -half * shape, right: half * shape, top: half, bottom: -half });
      this.planCamera.updateProjectionMatrix();
    }
    this.active.updateMatrixWorld(true);
    this.mark(stage);
    this.renderer.render(this.scene, this.active);
  }

  /** Set pieces that are not shown: those that the shot takes away, or that stand before the free camera. */
  private hidden(stage: Stage): Set<string> {
    if (this.view === "shot") return new Set(this.camera?.hidden);
    if (this.view === "plan") return new Set();
    return inTheWay(this.model, [...Object.keys(stage.placed), ...Object.keys(stage.people)], this.freeCamera.position);
  }

  /** Metres that a pixel of the page is wide at a point. */
  private pixel = (at: Vector3): number => {
    const high = Math.max(this.canvas.clientHeight, 1);
    if (this.active === this.planCamera) return (this.planCamera.top - this.planCamera.bottom) / this.planCamera.zoom / high;
    const camera = this.active as PerspectiveCamera;
    return (2 * camera.position.distanceTo(at) * Math.tan((camera.fov * Math.PI) / 360)) / high;
  };

  /** Draw cameras, lamps and ways, the box of what is chosen with its ring, and the boxes that it has come to stand in. */
  private mark(stage: Stage): void {
    clear(this.over);
    if (this.view !== "shot") this.over.add(...overlay(stage, this.chosen, this.pixel).children);
    if (!this.model.has(this.chosen)) return;
    const own = [this.chosen, ...(stage.placed[this.chosen]?.carries ?? [])];
    const within = this.model.collisions(own);
    this.stood ??= within;
    const hits = within.filter((node) => !this.stood!.includes(node));
    this.over.add(this.model.boxOf([this.chosen], hits.length ? HIT : CHOSEN));
    for (const node of this.hands.item ? hits : []) this.over.add(this.model.boxOf([node], HIT));
    if (nameOf(stage, this.chosen)) this.over.add(...ring(stage, this.chosen, this.pixel).children);
  }

  private ray(event: PointerEvent): Raycaster {
    const at = this.canvas.getBoundingClientRect();
    const point = new Vector2((event.clientX - at.left) / at.width, (event.clientY - at.top) / at.height);
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(point.x * 2 - 1, 1 - point.y * 2), this.active);
    return ray;
  }

  /** What is under the pointer: a handle, else a thing or a person; set pieces aside. */
  private under(ray: Raycaster): { item: string; point: Vector3 } | null {
    const grips = ray.intersectObject(this.over, true).filter((hit) => hit.object.name);
    if (grips.length) return { item: grips[0].object.name, point: grips[0].point };
    const found = this.model.under(ray, this.view === "plan");
    return found && { item: found.node, point: found.point };
  }

  /** Whose way is under the pointer, and where on the floor that is. */
  private wayUnder(event: PointerEvent): [string, FloorPoint] | null {
    const box = this.canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    for (const [id, person] of this.view === "shot" ? [] : Object.entries(this.stage!.people)) {
      const way = (person.walks[0] ?? []).map(([wx, wy]) => this.seenAt(new Vector3(wx, wy, 0), this.active));
      for (let index = 1; index < way.length; index++) {
        const [[ax, ay], [bx, by]] = [way[index - 1], way[index]].map(([u, v]) => [u * box.width, v * box.height]);
        const share = Math.max(0, Math.min(1, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / Math.max(1e-9, (bx - ax) ** 2 + (by - ay) ** 2)));
        if (Math.hypot(ax + share * (bx - ax) - x, ay + share * (by - ay) - y) > NEAR_WAY) continue;
        const [from, to] = [person.walks[0][index - 1], person.walks[0][index]];
        return [id, [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])]];
      }
    }
    return null;
  }

  private press(event: PointerEvent): void {
    if (event.button !== 0 || !this.stage) return;
    const ray = this.ray(event);
    const hit = this.under(ray);
    const way = hit && this.model.has(hit.item) === false ? null : this.wayUnder(event);
    const pixels: [number, number] = [event.clientX, event.clientY];
    if (way) this.hands.bend(this.stage, way[0], way[1]);
    else if (hit) this.hands.take(this.stage, hit.item, this.tool, hit.point, pixels);
    this.choose(this.hands.item || (hit?.item ?? ""));
    this.told.chose(this.chosen);
    if (!this.hands.item) return;
    this.switchControls();
    this.canvas.setPointerCapture(event.pointerId);
  }

  private pull(event: PointerEvent): void {
    if (!this.hands.item || !this.stage) return;
    const at = new Vector3(...spotOf(this.stage, this.hands.item)!);
    this.hands.pull(this.stage, this.ray(event), [event.clientX, event.clientY], this.pixel(at), event.altKey, event.shiftKey);
    this.told.changed();
    this.draw();
  }

  private release(): void {
    const done = this.stage && this.hands.release(this.stage);
    this.switchControls();
    if (done) this.told.done(done);
    this.draw();
  }

  /** Put back what is being dragged; says whether anything was. */
  cancel(): boolean {
    const before = this.hands.cancel();
    if (!before) return false;
    this.stage = before;
    this.chosen = nameOf(before, this.chosen) ? this.chosen : partsOf(this.chosen)[1];
    this.switchControls();
    this.told.changed();
    this.draw();
    return true;
  }
}
