/** Cameras of the stage: those of the shots, exactly as Blender has them, and cameras that stand where a hand put them. */

import { MathUtils, Matrix4, type PerspectiveCamera, Vector3 } from "three";
import type { CameraKey, Point, StageCamera } from "./stage_values";

/** A camera as an edit takes it: where it stands, what it looks at, degrees that it leans counter-clockwise. */
export interface CameraPose {
  location: Point;
  target: Point;
  roll: number;
}

/** The key of a camera at a frame; cameras are keyed so closely that between two keys a straight line will do. */
export function keyAt(camera: StageCamera, frame: number): CameraKey {
  const after = camera.keys.findIndex((key) => key.frame >= frame);
  if (after <= 0) return camera.keys[after === 0 ? 0 : camera.keys.length - 1];
  const [from, to] = [camera.keys[after - 1], camera.keys[after]];
  const share = (frame - from.frame) / (to.frame - from.frame);
  const mixed = (one: number, other: number) => one + (other - one) * share;
  return {
    frame,
    world: from.world.map((value, index) => mixed(value, to.world[index])),
    lens: mixed(from.lens, to.lens),
    distance: mixed(from.distance, to.distance),
  };
}

export function worldOf(key: CameraKey): Matrix4 {
  return new Matrix4().fromArray(key.world).transpose();
}

/** Let a camera of the page see what a camera of a shot sees at a frame. */
export function look(through: PerspectiveCamera, camera: StageCamera, frame: number, aspect: number): void {
  const key = keyAt(camera, frame);
  worldOf(key).decompose(through.position, through.quaternion, through.scale);
  through.aspect = aspect;
  through.fov = (2 * Math.atan(camera.sensor_width / aspect / (2 * key.lens)) * 180) / Math.PI;
  through.updateProjectionMatrix();
  through.updateMatrixWorld(true);
}

/** Where a camera stands at the start or at the end of its shot. */
export function poseOf(camera: StageCamera, when: "start" | "end"): CameraPose {
  const key = camera.keys.at(when === "start" ? 0 : -1)!;
  const world = worldOf(key);
  const [right, up, back] = [new Vector3(), new Vector3(), new Vector3()];
  world.extractBasis(right, up, back);
  const eye = new Vector3().setFromMatrixPosition(world);
  const level = levelAxes(back);
  const roll = MathUtils.radToDeg(Math.atan2(right.dot(level.up), right.dot(level.right)));
  return {
    location: eye.toArray(),
    target: eye.clone().addScaledVector(back, -key.distance).toArray(),
    roll: Math.abs(roll) < 0.05 ? 0 : roundTo(roll, 2),
  };
}

/** The key of a camera that stands where a pose says. */
export function keyOf(pose: CameraPose, frame: number, lens: number): CameraKey {
  const [eye, target] = [new Vector3(...pose.location), new Vector3(...pose.target)];
  const back = eye.clone().sub(target).normalize();
  const { right, up } = levelAxes(back);
  const turn = MathUtils.degToRad(pose.roll);
  const leaning = right.clone().multiplyScalar(Math.cos(turn)).addScaledVector(up, Math.sin(turn));
  const world = new Matrix4().makeBasis(leaning, back.clone().cross(leaning), back).setPosition(eye);
  return { frame, world: world.transpose().toArray(), lens, distance: eye.distanceTo(target) };
}

/** Whether a camera ends its shot elsewhere than it begins it. */
export function travels(camera: StageCamera): boolean {
  return camera.keys.length > 1 && camera.keys[0].world.some((value, index) => Math.abs(value - camera.keys.at(-1)!.world[index]) > 1e-4);
}

/** The axes of a camera that does not lean, by the direction it looks away from. */
function levelAxes(back: Vector3): { right: Vector3; up: Vector3 } {
  const right = new Vector3(0, 0, 1).cross(back);
  if (right.length() < 1e-6) right.set(1, 0, 0);
  right.normalize();
  return { right, up: back.clone().cross(right) };
}

export function roundTo(value: number, digits: number): number {
  return Math.round(value * 10 ** digits) / 10 ** digits;
}
