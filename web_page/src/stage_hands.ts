/** Hands on the stage: what the pointer takes hold of is moved, turned or scaled with it until it is let go. */

import { Matrix4, Plane, type Raycaster, Vector3 } from "three";
import { nameOf, placeAmong, put, spotOf, turnOf } from "./stage_items";
import type { StageModel } from "./stage_model";
import type { FloorPoint, Point, Stage } from "./stage_values";

export type Tool = "move" | "turn" | "scale";

/** What a gesture came to; the stage has it already. */
export interface Done {
  item: string;
  tool: Tool;
  /** Degrees, of a turn. */
  turned: number;
  /** Factor, of a scale. */
  scale: number;
  /** Whether it stays at the height that it has. */
  lifted: boolean;
}

/** Smallest move in metres, turn in degrees and share of a scale that are meant. */
const MEANT = { move: 0.005, turn: 0.5, scale: 0.01 };
const SNAP = 15;
const UP = new Vector3(0, 0, 1);

interface Drag extends Done {
  nodes: string[];
  /** The item as it was, and where it was taken hold of. */
  from: Vector3;
  grip: Vector3;
  pixels: [number, number];
  before: Stage;
  /** Whether it is new. */
  added: boolean;
}

export class StageHands {
  private drag: Drag | null = null;

  constructor(private model: StageModel) {}

  get item(): string {
    return this.drag?.item ?? "";
  }

  /** The nodes that are being moved. */
  get nodes(): string[] {
    return this.drag?.nodes ?? [];
  }

  take(stage: Stage, item: string, tool: Tool, grip: Vector3, pixels: [number, number]): void {
    const turning = item.startsWith("turn:");
    const of = turning ? item.slice(5) : item;
    const spot = spotOf(stage, of);
    if (!spot || !nameOf(stage, of)) return;
    const carried = stage.placed[of]?.carries ?? [];
    const isNode = this.model.has(of);
    const which = turning ? "turn" : isNode && (tool !== "scale" || of in stage.placed) ? tool : "move";
    this.model.settle();
    this.drag = {
      item: of, tool: which, turned: 0, scale: 1, lifted: false, added: false, pixels, before: structuredClone(stage),
      nodes: isNode ? [of, ...carried] : [], from: new Vector3(...spot), grip,
    };
  }

  /** Add a way point where the way of a person is taken hold of. */
  bend(stage: Stage, person: string, at: FloorPoint): void {
    const before = structuredClone(stage);
    const place = placeAmong(stage, person, at);
    stage.people[person].via.splice(place, 0, at);
    this.take(stage, `via:${person}:${place}`, "move", new Vector3(...at, 0), [0, 0]);
    Object.assign(this.drag!, { before, added: true });
  }

  /**
   * Follow the pointer.
   * @param fine Turn without steps; keep the height that a thing has.
   * @param upright Move up and down instead of along the floor.
   */
  pull(stage: Stage, ray: Raycaster, pixels: [number, number], pixel: number, fine: boolean, upright: boolean): void {
    const drag = this.drag;
    if (!drag) return;
    if (drag.tool === "turn") this.turn(stage, drag, ray, fine);
    else if (drag.tool === "scale") this.scale(drag, pixels);
    else if (upright) this.lift(stage, drag, (drag.pixels[1] - pixels[1]) * pixel);
    else this.shift(stage, drag, ray, fine);
  }

  private shift(stage: Stage, drag: Drag, ray: Raycaster, fine: boolean): void {
    const height = drag.nodes.length ? drag.grip.z : drag.from.z;
    const point = ray.ray.intersectPlane(new Plane(UP, -height), new Vector3());
    if (!point) return;
    const to = drag.nodes.length ? drag.from.clone().add(point.sub(drag.grip)) : point;
    to.z = spotOf(stage, drag.item)![2];
    const thing = stage.placed[drag.item];
    drag.lifted = fine && thing !== undefined;
    if (drag.lifted) to.z = drag.from.z;
    else if (thing?.rests === "surface") to.z = this.model.heightBelow(to.x, to.y, this.model.box(drag.item).max.z + 1.5, drag.nodes);
    this.putAt(stage, drag, to);
  }

  private lift(stage: Stage, drag: Drag, by: number): void {
    const now = new Vector3(...spotOf(stage, drag.item)!);
    drag.lifted = true;
    this.putAt(stage, drag, now.setZ(Math.max(0, drag.from.z + by)));
  }

  private putAt(stage: Stage, drag: Drag, to: Vector3): void {
    put(stage, drag.item, to.toArray() as Point);
    const by = to.clone().sub(drag.from);
    this.model.move(drag.nodes, new Matrix4().makeTranslation(by));
  }

  private turn(stage: Stage, drag: Drag, ray: Raycaster, fine: boolean): void {
    const point = ray.ray.intersectPlane(new Plane(UP, -drag.from.z), new Vector3());
    if (!point) return;
    const angle = (of: Vector3) => (Math.atan2(of.x - drag.from.x, drag.from.y - of.y) * 180) / Math.PI;
    const was = turnOf(drag.before, drag.item) ?? 0;
    let turned = angle(point) - angle(drag.grip);
    if (!fine) turned = Math.round((was + turned) / SNAP) * SNAP - was;
    drag.turned = ((((turned + 180) % 360) + 360) % 360) - 180;
    turn(stage, this.model, drag.nodes, drag.item, was + drag.turned, drag.turned);
  }

  private scale(drag: Drag, pixels: [number, number]): void {
    drag.scale = Math.min(10, Math.max(0.1, 2 ** ((pixels[0] - drag.pixels[0] + drag.pixels[1] - pixels[1]) / 150)));
    const change = new Matrix4().makeTranslation(drag.from).scale(new Vector3().setScalar(drag.scale));
    this.model.move(drag.nodes, change.multiply(new Matrix4().makeTranslation(drag.from.clone().negate())));
  }

  /** Let go; what was meant is returned. */
  release(stage: Stage): Done | null {
    const drag = this.drag;
    if (!drag) return null;
    this.drag = null;
    const moved = new Vector3(...spotOf(stage, drag.item)!).distanceTo(drag.from);
    const much = { move: moved, turn: Math.abs(drag.turned), scale: Math.abs(drag.scale - 1) }[drag.tool];
    return drag.added || much > MEANT[drag.tool] ? drag : null;
  }

  /** Put back what is held; returns the stage as it was before, or null where nothing was held. */
  cancel(): Stage | null {
    const drag = this.drag;
    this.drag = null;
    if (drag) this.model.move(drag.nodes, new Matrix4());
    return drag?.before ?? null;
  }
}

/** Turn nodes about where an item stands; the stage is changed. */
export function turn(stage: Stage, model: StageModel, nodes: string[], item: string, to: number, by: number): void {
  const about = new Vector3(...spotOf(stage, item)!);
  const change = new Matrix4().makeTranslation(about).multiply(new Matrix4().makeRotationZ((by * Math.PI) / 180));
  model.move(nodes, change.multiply(new Matrix4().makeTranslation(about.clone().negate())));
  (stage.placed[item] ?? stage.people[item]).rotation = ((to % 360) + 360) % 360;
}
