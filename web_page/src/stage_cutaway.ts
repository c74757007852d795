/** The free view as into a doll's house: walls, ceilings and other large set pieces between the camera and the scene are cut away. */

import { Box3, Ray, Vector3 } from "three";
import type { StageModel } from "./stage_model";

/** Metres: so near to people and things the camera is among them, and nothing is cut away; so far within them ground is to be seen. */
const AMONG = 0.3;

/** Metres across of the smallest set piece that is cut away; a rock or a shelf stays. */
const LARGE = 2;

/**
 * The set pieces that hide people, things or the ground between them from a camera.
 * @param model The scene.
 * @param seen People and things that are to be seen, by node id.
 * @param eye Where the camera is.
 */
export function inTheWay(model: StageModel, seen: string[], eye: Vector3): Set<string> {
  const boxes = seen.map((node) => model.box(node)).filter((box) => !box.isEmpty());
  const scene = boxes.reduce((all, box) => all.union(box), new Box3());
  if (scene.isEmpty() || scene.clone().expandByScalar(AMONG).containsPoint(eye)) return new Set();
  const { min, max } = scene.expandByScalar(-AMONG);
  const corners = [min.x, max.x].flatMap((x) => [min.y, max.y].map((y) => new Vector3(x, y, min.z)));
  const points = [...boxes.map((box) => box.getCenter(new Vector3())), ...corners];
  const large = (box: Box3) => box.getSize(new Vector3()).length() >= LARGE;
  return new Set(model.setPieces.filter((piece) => large(model.box(piece)) && hides(model.box(piece), points, eye)));
}

/** Whether a box is between a camera and any of some points; what a point is in, such as a terrain, hides it not. */
function hides(box: Box3, points: Vector3[], eye: Vector3): boolean {
  const met = new Vector3();
  return points.some((point) => {
    const ray = new Ray(eye, point.clone().sub(eye).normalize());
    return !box.containsPoint(point) && ray.intersectBox(box, met) !== null && met.distanceTo(eye) < point.distanceTo(eye);
  });
}
