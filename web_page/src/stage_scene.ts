/** The stage: a scene in 3D in Blender's coordinates (metres, Z up), seen through a shot, freely, or from above. */

import {
  Box3, Box3Helper, Color, DirectionalLight, Group, HemisphereLight, type Material, Mesh, MeshLambertMaterial, type MeshStandardMaterial,
  type Object3D, OrthographicCamera, PerspectiveCamera, Plane, Quaternion, Raycaster, Scene, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import type { Stage } from "./messages";
import { cone, keyAt, look, worldOf } from "./stage_cameras";

export type View = "shot" | "free" | "plan";

const CHOSEN = 0x6fb1ff;
const HIT = 0xff5a4a;
/** Metres: what is above is cut off in the plan. */
const PLAN_HEIGHT = 2.3;
/** Metres that boxes may share before it is a collision. */
const TOUCHING = 0.03;

export interface Moved {
  node: string;
  by: { x: number; y: number };
}

export class StageScene {
  readonly scene = new Scene();
  private renderer: WebGLRenderer;
  private shotCamera = new PerspectiveCamera(40, 16 / 9, 0.05, 1000);
  private freeCamera = new PerspectiveCamera(40, 16 / 9, 0.05, 1000);
  private planCamera = new OrthographicCamera(-5, 5, 5, -5, 0, 100);
  private free: OrbitControls;
  private plan: OrbitControls;
  private model = new Group();
  private overlay = new Group();
  private nodes = new Map<string, Object3D[]>();
  private asked = 0;
  private drawing = 0;
  private drag: { node: string; from: Vector3; height: number; by: Vector2 } | null = null;
  stage: Stage | null = null;
  view: View = "shot";
  frame = 0;
  chosen = "";

  constructor(
    private canvas: HTMLCanvasElement,
    private told: { chose(node: string): void; moved(moved: Moved): void },
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.scene.background = new Color(0x2a2d33);
    const sun = new DirectionalLight(0xffffff, 1.6);
    sun.position.set(3, -6, 9);
    this.scene.add(new HemisphereLight(0xffffff, 0x8a7f70, 2.0), sun, this.model, this.overlay);
    this.freeCamera.up.set(0, 0, 1);
    this.planCamera.up.set(0, 1, 0);
    this.free = new OrbitControls(this.freeCamera, canvas);
    this.plan = new OrbitControls(this.planCamera, canvas);
    this.plan.enableRotate = false;
    for (const controls of [this.free, this.plan]) controls.addEventListener("change", () => this.draw());
    canvas.addEventListener("pointerdown", (event) => this.press(event), { capture: true });
    canvas.addEventListener("pointermove", (event) => this.pull(event));
    canvas.addEventListener("pointerup", () => this.release());
    canvas.addEventListener("webglcontextrestored", () => this.draw());
    this.switchControls();
  }

  dispose(): void {
    cancelAnimationFrame(this.drawing);
    this.free.dispose();
    this.plan.dispose();
    this.renderer.dispose();
  }

  /** Show a stage; the model is loaded unless it is shown already. */
  async show(stage: Stage): Promise<void> {
    const [before, asked] = [this.stage, ++this.asked];
    if (before?.model !== stage.model) {
      const loaded = (await new GLTFLoader().loadAsync(stage.model)).scene;
      if (asked !== this.asked) return;
      this.stand(loaded);
    }
    this.stage = stage;
    this.frame = stage.frame;
    if (before?.shot.slice(0, 5) !== stage.shot.slice(0, 5)) this.frameAll();
    if (before?.shot !== stage.shot) this.startFree();
    this.choose(this.nodes.has(this.chosen) ? this.chosen : "");
  }

  /** Show the model as it was loaded, whatever was moved in it. */
  async putBack(): Promise<void> {
    const stage = this.stage;
    if (!stage) return;
    this.stage = { ...stage, model: "" };
    await this.show(stage);
  }

  /** Take the place of the model that was shown. */
  private stand(loaded: Object3D): void {
    this.model.clear();
    this.nodes.clear();
    loaded.rotation.x = Math.PI / 2; // glTF has Y up
    this.model.add(loaded);
    this.model.updateMatrixWorld(true);
    loaded.traverse((each) => {
      if (each instanceof Mesh) each.material = plain(each.material as MeshStandardMaterial);
      const id = each.userData.node_id as string | undefined;
      if (id) this.nodes.set(id, [...(this.nodes.get(id) ?? []), each]);
    });
  }

  look(view: View): void {
    this.view = view;
    this.switchControls();
    this.draw();
  }

  seek(frame: number): void {
    this.frame = frame;
    this.draw();
  }

  choose(node: string): void {
    this.chosen = node;
    this.draw();
  }

  /** Turn a thing where it stands, until the studio has placed it so. */
  turn(node: string, degrees: number): void {
    const about = this.stage?.placed[node]?.location ?? this.stage?.people[node]?.start;
    if (!about) return;
    const turned = new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), (degrees * Math.PI) / 180);
    for (const part of this.nodes.get(node) ?? []) {
      const pivot = part.parent!.worldToLocal(new Vector3(...about));
      part.position.sub(pivot).applyQuaternion(turned).add(pivot);
      part.quaternion.premultiply(turned);
    }
    this.model.updateMatrixWorld(true);
    this.draw();
  }

  resize(width: number, height: number): void {
    this.renderer.setSize(width, height, false);
    this.draw();
  }

  /** Where the free camera is, as an edit of the shot's camera takes it. */
  get freePose(): { location: number[]; target: number[]; lens: number } {
    const sensor = this.camera?.sensor_width ?? 36;
    const lens = sensor / (this.stage?.aspect ?? 1) / (2 * Math.tan((this.freeCamera.fov * Math.PI) / 360));
    return { location: this.freeCamera.position.toArray(), target: this.free.target.toArray(), lens };
  }

  /** Where points of the scene are in the shot's picture: 0 to 1 from the left and from the top. */
  pictured(points: number[][]): number[][] {
    if (this.stage && this.camera) look(this.shotCamera, this.camera, this.frame, this.stage.aspect);
    return points.map((point) => {
      const seen = new Vector3(...(point as [number, number, number])).project(this.shotCamera);
      return [(seen.x + 1) / 2, (1 - seen.y) / 2];
    });
  }

  /** Where the middle of a thing is in the view: 0 to 1 from the left and from the top. */
  onScreen(node: string): number[] {
    const seen = this.box(node).getCenter(new Vector3()).project(this.active);
    return [(seen.x + 1) / 2, (1 - seen.y) / 2];
  }

  private get camera() {
    return this.stage?.cameras.find((each) => each.shot === this.stage?.shot);
  }

  private get active(): PerspectiveCamera | OrthographicCamera {
    return { shot: this.shotCamera, free: this.freeCamera, plan: this.planCamera }[this.view];
  }

  private switchControls(): void {
    this.free.enabled = this.view === "free";
    this.plan.enabled = this.view === "plan";
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
    for (const id of Object.keys(this.stage?.placed ?? {})) for (const part of this.nodes.get(id) ?? []) all.expandByObject(part);
    for (const camera of this.stage?.cameras ?? []) all.expandByPoint(new Vector3().setFromMatrixPosition(worldOf(camera.keys[0])));
    if (all.isEmpty()) all.setFromObject(this.model);
    const [middle, size] = [all.getCenter(new Vector3()), all.getSize(new Vector3())];
    this.planCamera.position.set(middle.x, middle.y, PLAN_HEIGHT);
    this.plan.target.set(middle.x, middle.y, 0);
    this.planCamera.zoom = 1;
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
    const shape = width / Math.max(height, 1);
    const hidden = new Set(this.view === "shot" ? this.camera?.hidden : []);
    for (const [id, parts] of this.nodes) for (const part of parts) part.visible = !hidden.has(id);
    if (this.view === "shot" && this.camera) {
      look(this.shotCamera, this.camera, this.frame, stage.aspect);
    } else if (this.view === "free") {
      this.freeCamera.aspect = shape;
      this.freeCamera.updateProjectionMatrix();
    } else {
      const [across, along] = (this.planCamera.userData.span as [number, number] | undefined) ?? [10, 10];
      const half = Math.max(along, across / shape) / 2;
      Object.assign(this.planCamera, { left: -half * shape, right: half * shape, top: half, bottom: -half });
      this.planCamera.updateProjectionMatrix();
    }
    this.mark(stage);
    this.renderer.render(this.scene, this.active);
  }

  /** Draw cameras, the box of what is chosen, and the boxes that it stands in. */
  private mark(stage: Stage): void {
    this.overlay.clear();
    if (this.view !== "shot") {
      for (const camera of stage.cameras) {
        const own = camera.shot === stage.shot;
        this.overlay.add(cone(camera, own ? this.frame : 0, stage.aspect, own ? 0xe8b04a : 0x8d9099));
      }
    }
    if (!this.chosen) return;
    const hits = this.collisions(this.chosen);
    this.overlay.add(new Box3Helper(this.box(this.chosen), hits.length ? HIT : CHOSEN));
    for (const node of this.drag ? hits : []) this.overlay.add(new Box3Helper(this.box(node), HIT));
  }

  private box(node: string): Box3 {
    const box = new Box3();
    for (const part of this.nodes.get(node) ?? []) box.expandByObject(part);
    return box;
  }

  /** What a thing stands in: placed things and people whose boxes meet its own. */
  private collisions(node: string): string[] {
    const own = this.box(node).expandByScalar(-TOUCHING);
    return [...this.nodes.keys()].filter((other) => {
      const kind = this.nodes.get(other)![0].userData.kind;
      return other !== node && (kind === "prop" || kind === "character") && this.box(other).intersectsBox(own);
    });
  }

  private ray(event: PointerEvent): Raycaster {
    const at = this.canvas.getBoundingClientRect();
    const point = new Vector2((event.clientX - at.left) / at.width, (event.clientY - at.top) / at.height);
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(point.x * 2 - 1, 1 - point.y * 2), this.active);
    return ray;
  }

  /** What is under the pointer, set pieces aside. */
  private under(event: PointerEvent): { node: string; point: Vector3 } | null {
    for (const hit of this.ray(event).intersectObject(this.model, true)) {
      let each: Object3D | null = hit.object;
      while (each && !each.userData.node_id) each = each.parent;
      if (!each || !hit.object.visible) continue;
      if (each.userData.kind === "set" && this.view === "plan") continue;
      return each.userData.kind === "set" ? null : { node: each.userData.node_id as string, point: hit.point };
    }
    return null;
  }

  private press(event: PointerEvent): void {
    if (event.button !== 0) return;
    const hit = this.under(event);
    this.choose(hit?.node ?? "");
    this.told.chose(this.chosen);
    if (!hit || this.view === "shot" || !this.stage || !(hit.node in this.stage.placed || hit.node in this.stage.people)) return;
    this.drag = { node: hit.node, from: hit.point, height: hit.point.z, by: new Vector2() };
    this.free.enabled = this.plan.enabled = false;
    this.canvas.setPointerCapture(event.pointerId);
  }

  private pull(event: PointerEvent): void {
    if (!this.drag) return;
    const point = this.ray(event).ray.intersectPlane(new Plane(new Vector3(0, 0, 1), -this.drag.height), new Vector3());
    if (point) this.shift(new Vector2(point.x - this.drag.from.x, point.y - this.drag.from.y));
  }

  private shift(by: Vector2): void {
    const drag = this.drag!;
    for (const part of this.nodes.get(drag.node) ?? []) {
      part.position.x += by.x - drag.by.x;
      part.position.z -= by.y - drag.by.y; // the model has Y up below its turned root
    }
    drag.by = by;
    this.model.updateMatrixWorld(true);
    this.draw();
  }

  private release(): void {
    const drag = this.drag;
    this.drag = null;
    this.switchControls();
    if (drag && drag.by.length() > 0.005) this.told.moved({ node: drag.node, by: drag.by });
    this.draw();
  }

  /** Put back what is being dragged; says whether anything was. */
  cancel(): boolean {
    if (!this.drag) return false;
    this.shift(new Vector2());
    this.drag = null;
    this.switchControls();
    this.draw();
    return true;
  }
}

/** A quick material with the colours of a rich one. */
function plain(material: MeshStandardMaterial | Material[]): Material | Material[] {
  if (Array.isArray(material)) return material.map((each) => plain(each as MeshStandardMaterial) as Material);
  const { color, map, opacity, transparent, side, emissive, emissiveIntensity, vertexColors } = material;
  return new MeshLambertMaterial({ color, map, opacity, transparent, side, vertexColors, emissive, emissiveIntensity: Math.min(emissiveIntensity, 0.6) });
}
