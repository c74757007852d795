/** One person or thing in 3D, to be turned and measured: metres, Z up, its front towards the viewer. */

import {
  Box3, Color, DirectionalLight, DoubleSide, GridHelper, Group, HemisphereLight, Mesh, MeshBasicMaterial, type MeshStandardMaterial, type Object3D,
  PerspectiveCamera, Quaternion, Scene, Shape, ShapeGeometry, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { plain } from "./stage_model";
import type { Point } from "./stage_values";

export type Axis = "x" | "y" | "z";
/** Metres of the person who stands beside things as a measure. */
export const MEASURE = 1.75;
/** Metres below which a thing is measured on squares of ten centimetres, and nobody stands beside it. */
const SMALL = 0.6;
/** Times as large or as small: from there on what takes the place of something is looked at as a whole. */
const OTHER_SIZE = 1.6;
/** Degrees that a key turns the view. */
const STEP = 10;
const SIDES: Record<string, Point> = {
  front: [0, -1, 0], back: [0, 1, 0], right: [1, 0, 0], left: [-1, 0, 0], top: [0, 0, 1], bottom: [0, 0, -1],
};
const AXES: Record<Axis, Vector3> = { x: new Vector3(1, 0, 0), y: new Vector3(0, 1, 0), z: new Vector3(0, 0, 1) };

export class AssetScene {
  private scene = new Scene();
  private renderer: WebGLRenderer;
  private camera = new PerspectiveCamera(32, 1, 0.01, 500);
  private controls: OrbitControls;
  private model = new Group();
  private around = new Group();
  private asked = 0;
  private drawing = 0;
  /** Who or what is shown. */
  private of = "";
  /** Metres across its box. */
  private extent = 0;
  /** Address of what is shown. */
  shown = "";
  /** Metres of a square of the ground. */
  square = 1;

  constructor(canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.scene.background = new Color(0x34373e);
    const sun = new DirectionalLight(0xffffff, 1.7);
    sun.position.set(-3, -6, 8);
    this.scene.add(new HemisphereLight(0xffffff, 0x9a8f80, 1.9), sun, this.model, this.around);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    canvas.addEventListener("webglcontextrestored", () => this.draw());
  }

  dispose(): void {
    cancelAnimationFrame(this.drawing);
    this.controls.dispose();
    this.renderer.dispose();
  }

  /** Show a model of a person or a thing; the view stays where they are shown already, about as large. */
  async show(address: string, of: string): Promise<void> {
    const asked = ++this.asked;
    const loaded = (await new GLTFLoader().loadAsync(address)).scene;
    if (asked !== this.asked) return;
    loaded.rotation.x = Math.PI / 2; // glTF has Y up
    loaded.traverse((each) => {
      if (each instanceof Mesh) each.material = plain(each.material as MeshStandardMaterial);
    });
    this.model.clear();
    this.model.add(loaded);
    this.model.quaternion.identity();
    this.model.position.set(0, 0, 0);
    this.measure();
    const extent = this.box.getSize(new Vector3()).length();
    if (of !== this.of || Math.abs(Math.log(extent / this.extent)) > Math.log(OTHER_SIZE)) this.fit();
    [this.shown, this.of, this.extent] = [address, of, extent];
    this.draw();
  }

  /** Turn the model by quarters, on its feet again. */
  turn(axis: Axis, quarters: number): void {
    const turned = new Quaternion().setFromAxisAngle(AXES[axis], (quarters * Math.PI) / 2);
    this.model.quaternion.premultiply(turned);
    this.stand();
  }

  /** Turn the model as it is where these sides of it are front and top. */
  pose(front: string, top: string): void {
    const [forward, up] = [new Vector3(...SIDES[front]), new Vector3(...SIDES[top])];
    const first = new Quaternion().setFromUnitVectors(up, AXES.z);
    const seen = forward.applyQuaternion(first);
    const about = new Quaternion().setFromAxisAngle(AXES.z, -Math.PI / 2 - Math.atan2(seen.y, seen.x));
    this.model.quaternion.copy(about.multiply(first));
    this.stand();
  }

  /** Which sides of the model, as its file has it, are front and top now. */
  get sides(): { front: string; top: string } {
    const back = this.model.quaternion.clone().invert();
    return { front: sideOf(new Vector3(0, -1, 0).applyQuaternion(back)), top: sideOf(new Vector3(0, 0, 1).applyQuaternion(back)) };
  }

  /** Look at the whole from a little above, its front at the left. */
  fit(): void {
    const box = this.box;
    const [middle, size] = [box.getCenter(new Vector3()), box.getSize(new Vector3())];
    const radius = Math.max(size.length() / 2, 0.01);
    const half = (this.camera.fov * Math.PI) / 360;
    const away = (radius * 1.06) / Math.sin(Math.min(half, Math.atan(Math.tan(half) * this.camera.aspect)));
    this.controls.target.copy(middle);
    this.camera.position.copy(middle).add(new Vector3(-0.42, -1, 0.3).normalize().multiplyScalar(away));
    [this.camera.near, this.camera.far] = [away / 200, away * 20];
    [this.controls.minDistance, this.controls.maxDistance] = [radius / 4, away * 4];
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  resize(width: number, height: number): void {
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(height, 1);
    this.camera.updateProjectionMatrix();
    if (this.shown) this.fit();
  }

  /** Turn the view or come nearer by a key; says whether it was one of those. */
  key(key: string): boolean {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const about = (axis: Vector3, degrees: number) => offset.applyAxisAngle(axis, (degrees * Math.PI) / 180);
    const side = new Vector3().crossVectors(AXES.z, offset).normalize();
    if (key === "ArrowLeft") about(AXES.z, -STEP);
    else if (key === "ArrowRight") about(AXES.z, STEP);
    else if (key === "ArrowUp" && offset.angleTo(AXES.z) > 0.3) about(side, -STEP);
    else if (key === "ArrowDown" && offset.angleTo(AXES.z) < 2.2) about(side, STEP);
    else if (key === "+" || key === "=") offset.multiplyScalar(1 / 1.15);
    else if (key === "-") offset.multiplyScalar(1.15);
    else if (key === "Home") this.fit();
    else return false;
    if (key !== "Home") this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.draw();
    return true;
  }

  private get box(): Box3 {
    this.model.updateMatrixWorld(true);
    return new Box3().setFromObject(this.model, true);
  }

  /** Put the model on the ground, its middle at the origin. */
  private stand(): void {
    this.model.position.set(0, 0, 0);
    const box = this.box;
    const middle = box.getCenter(new Vector3());
    this.model.position.set(-middle.x, -middle.y, -box.min.z);
    this.measure();
    this.fit();
  }

  /** Lay the ground, and let a person stand beside a thing that is not small. */
  private measure(): void {
    const box = this.box;
    const size = box.getSize(new Vector3());
    const small = Math.max(size.x, size.y, size.z) < SMALL;
    this.square = small ? 0.1 : 1;
    const count = 2 * Math.ceil(Math.max(size.x, size.y, 2 * this.square) / this.square + 1);
    const ground = new GridHelper(count * this.square, count, 0x8d9099, 0x565a63);
    ground.rotation.x = Math.PI / 2;
    ground.position.z = Math.min(0, box.min.z) - 0.002 * this.square;
    this.around.clear();
    this.around.add(ground);
    if (!small) {
      const person = silhouette();
      person.position.set(box.max.x + 0.5, 0, 0);
      this.around.add(person);
    }
  }

  /** Draw the next time that the browser draws. */
  draw(): void {
    this.drawing ||= requestAnimationFrame(() => {
      this.drawing = 0;
      this.renderer.render(this.scene, this.camera);
    });
  }
}

function sideOf(direction: Vector3): string {
  const near = (side: string) => direction.dot(new Vector3(...SIDES[side]));
  return Object.keys(SIDES).reduce((best, side) => (near(side) > near(best) ? side : best));
}

/** A flat person of MEASURE, who faces the viewer. */
function silhouette(): Object3D {
  const half: [number, number][] = [
    [0, 0.8], [0.05, 0.8], [0.06, 0.02], [0.16, 0], [0.16, 0.06], [0.15, 0.85], [0.19, 0.9], [0.19, 1.05], [0.17, 1.15], [0.23, 0.85], [0.25, 0.78],
    [0.3, 0.78], [0.31, 0.86], [0.24, 1.4], [0.19, 1.46], [0.06, 1.5], [0.06, 1.53], [0.11, 1.6], [0.1, 1.7], [0.05, 1.745], [0, MEASURE],
  ];
  const shape = new Shape();
  const outline = [...half, ...half.slice(1, -1).reverse().map(([x, y]) => [-x, y] as [number, number])];
  outline.forEach(([x, y], at) => (at ? shape.lineTo(x, y) : shape.moveTo(x, y)));
  const person = new Mesh(new ShapeGeometry(shape), new MeshBasicMaterial({ color: 0x8d9099, transparent: true, opacity: 0.4, side: DoubleSide }));
  person.rotation.x = Math.PI / 2;
  return person;
}
