/** The model of the scene: its parts by node id, moved before the studio has moved them, and what they stand in. */

import {
  Box3, Box3Helper, type BufferGeometry, Group, type Material, Matrix4, Mesh, MeshLambertMaterial, type MeshStandardMaterial, type Object3D, Raycaster,
  Vector3,
} from "three";
import { OBB } from "three/addons/math/OBB.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

/** Metres that boxes may share before it is a collision. */
const TOUCHING = 0.03;
/** Cosine of the steepest surface that something stands on. */
const LEVEL = 0.9;

export class StageModel {
  readonly root = new Group();
  private nodes = new Map<string, Object3D[]>();
  private before = new Map<Object3D, Matrix4>();

  has(node: string): boolean {
    return this.nodes.has(node);
  }

  async load(address: string): Promise<Object3D> {
    return (await new GLTFLoader().loadAsync(address)).scene;
  }

  /** Show a model in place of the one that was shown. */
  stand(loaded: Object3D): void {
    this.root.traverse((each) => {
      if (each instanceof Mesh) (each.geometry as BufferGeometry).dispose();
    });
    this.root.clear();
    this.nodes.clear();
    this.before.clear();
    loaded.rotation.x = Math.PI / 2; // glTF has Y up
    this.root.add(loaded);
    this.root.updateMatrixWorld(true);
    loaded.traverse((each) => {
      if (each instanceof Mesh) each.material = plain(each.material as MeshStandardMaterial);
      const id = each.userData.node_id as string | undefined;
      if (id && nodeOf(each.parent)?.userData.node_id !== id) this.nodes.set(id, [...(this.nodes.get(id) ?? []), each]);
    });
  }

  /** Pieces of the set, such as walls, by node id. */
  get setPieces(): string[] {
    return [...this.nodes.keys()].filter((node) => this.nodes.get(node)![0].userData.kind === "set");
  }

  /** Hide set pieces that are taken away for a shot. */
  hide(hidden: Set<string>): void {
    for (const [id, parts] of this.nodes) for (const part of parts) part.visible = !hidden.has(id);
  }

  /** Put nodes where a change of the scene's coordinates puts them, counted from where the model has them. */
  move(nodes: string[], change: Matrix4): void {
    for (const part of nodes.flatMap((node) => this.nodes.get(node) ?? [])) {
      if (!this.before.has(part)) this.before.set(part, part.matrixWorld.clone());
      const local = part.parent!.matrixWorld.clone().invert().multiply(change).multiply(this.before.get(part)!);
      local.decompose(part.position, part.quaternion, part.scale);
      part.updateMatrixWorld(true);
    }
  }

  /** From now on, moves are counted from where everything is. */
  settle(): void {
    this.before.clear();
  }

  box(node: string): Box3 {
    const box = new Box3();
    for (const part of this.nodes.get(node) ?? []) box.expandByObject(part);
    return box;
  }

  boxOf(nodes: string[], color: number): Box3Helper {
    const box = new Box3();
    for (const node of nodes) box.union(this.box(node));
    return new Box3Helper(box, color);
  }

  /** What some nodes stand in: things and people whose turned boxes meet theirs. */
  collisions(nodes: string[]): string[] {
    const own = nodes.flatMap((node) => this.turned(node));
    return [...this.nodes.keys()].filter((other) => {
      const kind = this.nodes.get(other)![0].userData.kind;
      if (nodes.includes(other) || (kind !== "prop" && kind !== "character")) return false;
      const near = this.box(other).expandByScalar(-TOUCHING);
      return nodes.some((node) => this.box(node).intersectsBox(near)) && this.turned(other).some((box) => own.some((each) => each.intersectsOBB(box)));
    });
  }

  /** Boxes of a node's meshes, turned with them. */
  private turned(node: string): OBB[] {
    const boxes: OBB[] = [];
    for (const part of this.nodes.get(node) ?? []) {
      part.traverse((each) => {
        if (!(each instanceof Mesh)) return;
        const geometry = each.geometry as BufferGeometry;
        if (!geometry.boundingBox) geometry.computeBoundingBox();
        const box = new OBB().fromBox3(geometry.boundingBox!).applyMatrix4(each.matrixWorld);
        box.center.copy(geometry.boundingBox!.getCenter(new Vector3()).applyMatrix4(each.matrixWorld)); // OBB only shifts it
        box.halfSize.subScalar(TOUCHING / 2).max(new Vector3());
        boxes.push(box);
      });
    }
    return boxes;
  }

  /** The height of the highest level surface below a point that is no part of some nodes. */
  heightBelow(x: number, y: number, from: number, without: string[]): number {
    const ray = new Raycaster(new Vector3(x, y, from), new Vector3(0, 0, -1));
    for (const hit of ray.intersectObject(this.root, true)) {
      const node = nodeOf(hit.object)?.userData;
      if (!node || without.includes(node.node_id as string) || node.kind === "character" || !hit.face) continue;
      if (hit.face.normal.clone().transformDirection(hit.object.matrixWorld).z > LEVEL) return Math.max(0, hit.point.z);
    }
    return 0;
  }

  /** The first thing or person that a ray meets. */
  under(ray: Raycaster, throughSet: boolean): { node: string; point: Vector3 } | null {
    for (const hit of ray.intersectObject(this.root, true)) {
      const node = nodeOf(hit.object);
      if (!node || !isShown(hit.object)) continue;
      if (node.userData.kind !== "set") return { node: node.userData.node_id as string, point: hit.point };
      if (!throughSet) return null;
    }
    return null;
  }
}

/** The nearest object upwards that carries a node id. */
function nodeOf(each: Object3D | null): Object3D | null {
  while (each && !each.userData.node_id) each = each.parent;
  return each;
}

function isShown(each: Object3D | null): boolean {
  while (each?.visible) each = each.parent;
  return each === null;
}

/** A quick material with the colours of a rich one. */
export function plain(material: MeshStandardMaterial | Material[]): Material | Material[] {
  if (Array.isArray(material)) return material.map((each) => plain(each as MeshStandardMaterial) as Material);
  const { color, map, opacity, transparent, side, emissive, emissiveIntensity, vertexColors } = material;
  return new MeshLambertMaterial({ color, map, opacity, transparent, side, vertexColors, emissive, emissiveIntensity: Math.min(emissiveIntensity, 0.6) });
}
