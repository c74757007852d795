/** The free view as into a doll's house: walls, ceilings and other set pieces between the camera and the scene are cut away. */

import { Box3, Ray, Vector3 } from "three";
import type { StageModel } from "./stage_model";

/** Metres around people and things within which the free camera is among them, and nothing is cut away. */
const AMONG = 0.3;

/**
 * The set pieces that hide people or things from a camera.
 * @param model The scene.
 * @param seen People and things that are to be seen, by node id.
 * @param eye Where the camera is.
 */
export function inTheWay(model: StageModel, seen: string[], eye: Vector3): Set<string> {
  const boxes = seen.map((node) => model.box(node)).filter((box) => !box.isEmpty());
  const scene = boxes.reduce((all, box) => all.union(box), new Box3());
  if (scene.isEmpty() || scene.expandByScalar(AMONG).containsPoint(eye)) return new Set();
  const middles = boxes.map((box) => box.getCenter(new Vector3()));
  return new Set(model.setPieces.filter((piece) => hides(model.box(piece), middles, eye)));
}

/** Whether a box is between a camera and any of some points; what a point is in, such as a terrain, hides it not. */
function hides(box: Box3, points: Vector3[], eye: Vector3): boolean {
  const met = new Vector3();
  return points.some((point) => {
    const ray = new Ray(eye, point.clone().sub(eye).normalize());
    return !box.containsPoint(point) && ray.intersectBox(box, met) !== null && met.distanceTo(eye) < point.distanceTo(eye);
  });
}
