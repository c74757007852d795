/** Cameras of the stage: those of the shots, exactly as Blender has them, and how they are drawn from outside. */

import { BufferGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments, Matrix4, PerspectiveCamera, Vector3 } from "three";
import type { CameraKey, StageCamera } from "./messages";

/** Most metres that a camera's picture is drawn in front of it. */
const REACH = 2.5;

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

/** Lines from a camera to the corners of its picture. */
export function cone(camera: StageCamera, frame: number, aspect: number, color: number): LineSegments {
  const key = keyAt(camera, frame);
  const depth = Math.min(REACH, key.distance);
  const half = (depth * camera.sensor_width) / (2 * key.lens);
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) => new Vector3(x * half, (y * half) / aspect, -depth));
  const eye = new Vector3();
  const points = corners.flatMap((corner, index) => [eye, corner, corner, corners[(index + 1) % 4]]);
  const lines = new BufferGeometry();
  lines.setAttribute("position", new Float32BufferAttribute(points.flatMap((point) => point.toArray()), 3));
  const drawn = new LineSegments(lines, new LineBasicMaterial({ color, depthTest: false }));
  drawn.applyMatrix4(worldOf(key));
  drawn.renderOrder = 1;
  return drawn;
}
