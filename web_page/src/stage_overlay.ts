/** What is drawn over the scene: cameras with what they see, lamps, ways and marks of people, the ring that turns. */

import {
  BufferGeometry, CircleGeometry, Color, DoubleSide, Float32BufferAttribute, Group, Line, LineBasicMaterial, LineSegments, Mesh,
  MeshBasicMaterial, OctahedronGeometry, RingGeometry, SphereGeometry, Vector3,
} from "three";
import { keyAt, poseOf, travels, worldOf } from "./stage_cameras";
import { partsOf, spotOf, turnOf } from "./stage_items";
import type { CameraKey, Point, Stage, StageCamera } from "./stage_values";

const OWN = 0xe8b04a;
const OTHER = 0x8d9099;
const CHOSEN = 0x6fb1ff;
const WAY = 0x7fd0a0;
/** Most metres that a camera's picture is drawn in front of it. */
const REACH = 2.5;
/** Metres of a pixel at a camera through which the stage is seen, or nearly: it is not drawn. */
const BESIDE = 0.001;
/** Metres above the floor of what is drawn on it. */
const ON_FLOOR = 0.02;
/** Pixels: half the size of what can be grabbed, and the radius of the ring that turns. */
const GRIP = 7;
const RING = 46;
/** Pixels from a person to the mark that is dragged to send them somewhere. */
const SEND = 70;

/** Metres that a pixel is wide at a point of the view that is shown. */
export type PixelSize = (at: Vector3) => number;

/**
 * @param stage Where everything is.
 * @param chosen Item that has handles.
 * @param pixel Size of a pixel at a point.
 */
export function overlay(stage: Stage, chosen: string, pixel: PixelSize): Group {
  const group = new Group();
  const grip = (item: string, at: Point, color: number, shape: "ball" | "lamp" | "flat" = "ball") =>
    group.add(gripAt(item, at, item === chosen ? CHOSEN : color, shape, pixel));
  for (const camera of stage.cameras) addCamera(group, stage, camera, chosen, pixel, grip);
  for (const [name, lamp] of Object.entries(stage.lamps)) {
    if (lamp.kind === "SUN") continue;
    grip(`lamp:${name}`, lamp.location, tint(lamp.color), "lamp");
    if (partsOf(chosen)[1] !== name) continue;
    group.add(line([lamp.location, lamp.target], CHOSEN));
    grip(`lamp-aim:${name}`, lamp.target, tint(lamp.color));
  }
  for (const [id, person] of Object.entries(stage.people)) {
    person.walks.forEach((way) => group.add(line(way.map(([x, y]) => [x, y, ON_FLOOR]), WAY)));
    if (person.walks.length) grip(`mark:${id}:start`, person.start, WAY, "flat");
    if (person.walks.length || Math.hypot(person.end[0] - person.start[0], person.end[1] - person.start[1]) > 0.05) {
      grip(`mark:${id}:end`, person.end, WAY, "flat");
    } else if (partsOf(chosen)[1] === id) {
      const [x, y, z] = person.start;
      const beside: Point = [x + SEND * pixel(new Vector3(x, y, z)), y, z];
      group.add(line([person.start, beside], WAY));
      grip(`mark:${id}:end`, beside, WAY, "flat");
    }
    person.via.forEach(([x, y], index) => grip(`via:${id}:${index}`, [x, y, ON_FLOOR], WAY));
  }
  return group;
}

/** The ring around a thing or a person that turns it. */
export function ring(stage: Stage, item: string, pixel: PixelSize): Group {
  const group = new Group();
  const [spot, turn] = [spotOf(stage, item), turnOf(stage, item)];
  if (!spot || turn === null) return group;
  const middle = new Vector3(spot[0], spot[1], spot[2] + ON_FLOOR);
  const radius = RING * pixel(middle);
  const band = new Mesh(new RingGeometry(radius * 0.94, radius * 1.06, 48), flat(CHOSEN));
  band.position.copy(middle);
  band.name = `turn:${item}`;
  const angle = (turn * Math.PI) / 180;
  const knob: Point = [middle.x + radius * Math.sin(angle), middle.y - radius * Math.cos(angle), middle.z];
  group.add(gripAt(`turn:${item}`, knob, CHOSEN, "ball", pixel), above(band));
  return group;
}

function addCamera(
  group: Group, stage: Stage, camera: StageCamera, chosen: string, pixel: PixelSize, grip: (item: string, at: Point, color: number) => void,
): void {
  const own = camera.shot === stage.shot;
  const color = own ? OWN : OTHER;
  const ends = travels(camera) ? (["start", "end"] as const) : (["start"] as const);
  const seen = (key: CameraKey) => pixel(new Vector3().setFromMatrixPosition(worldOf(key))) > BESIDE;
  if (own && ends.length > 1) {
    if (seen(keyAt(camera, stage.frame))) group.add(frustum(camera, keyAt(camera, stage.frame), stage.aspect, color));
    group.add(line(camera.keys.map((key) => new Vector3().setFromMatrixPosition(worldOf(key)).toArray()), color));
  }
  const [, of] = partsOf(chosen);
  for (const when of ends) {
    if (!own && when === "end") continue;
    const key = camera.keys.at(when === "start" ? 0 : -1)!;
    if (!seen(key)) continue;
    group.add(frustum(camera, key, stage.aspect, color));
    const pose = poseOf(camera, when);
    grip(`camera:${camera.shot}:${when}`, pose.location, color);
    if (!own && of !== camera.shot) continue;
    group.add(line([pose.location, pose.target], of === camera.shot ? CHOSEN : color));
    grip(`aim:${camera.shot}:${when}`, pose.target, color);
  }
}

/** Lines from a camera to the corners of its picture, and the wedge that it sees. */
function frustum(camera: StageCamera, key: CameraKey, aspect: number, color: number): Group {
  const depth = Math.min(REACH, key.distance);
  const half = (depth * camera.sensor_width) / (2 * key.lens);
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) => new Vector3(x * half, (y * half) / aspect, -depth));
  const eye = new Vector3();
  const edges = new LineSegments(
    points(corners.flatMap((corner, index) => [eye, corner, corner, corners[(index + 1) % 4]])),
    new LineBasicMaterial({ color, depthTest: false }),
  );
  const wedge = new Mesh(points([eye, new Vector3(-half, 0, -depth), new Vector3(half, 0, -depth)]), flat(color, 0.14));
  const group = new Group();
  group.add(above(edges), above(wedge));
  group.applyMatrix4(worldOf(key));
  return group;
}

function gripAt(item: string, at: Point, color: number, shape: "ball" | "lamp" | "flat", pixel: PixelSize): Mesh {
  const size = GRIP * pixel(new Vector3(...at));
  const body = { ball: () => new SphereGeometry(size, 12, 8), lamp: () => new OctahedronGeometry(size * 1.4), flat: () => new CircleGeometry(size * 1.2, 20) }[shape]();
  const mesh = new Mesh(body, flat(color, shape === "ball" ? 0.85 : 1));
  mesh.position.set(...at);
  mesh.name = item;
  return above(mesh);
}

function line(way: Point[], color: number): Line {
  return above(new Line(points(way.map((point) => new Vector3(...point))), new LineBasicMaterial({ color, depthTest: false })));
}

function points(all: Vector3[]): BufferGeometry {
  return new BufferGeometry().setAttribute("position", new Float32BufferAttribute(all.flatMap((point) => point.toArray()), 3));
}

function flat(color: number, opacity = 1): MeshBasicMaterial {
  return new MeshBasicMaterial({ color, opacity, transparent: true, depthTest: false, side: DoubleSide });
}

/** Draw something over the scene. */
function above<Drawn extends Mesh | Line>(drawn: Drawn): Drawn {
  drawn.renderOrder = 1;
  return drawn;
}

/** The hue of a lamp, bright. */
function tint(color: Point): number {
  const most = Math.max(...color, 1e-6);
  return new Color().setRGB(color[0] / most, color[1] / most, color[2] / most).getHex();
}

/** Free the memory of what was drawn. */
export function clear(group: Group): void {
  group.traverse((each) => {
    if (each instanceof Mesh || each instanceof Line) {
      each.geometry.dispose();
      (each.material as MeshBasicMaterial).dispose();
    }
  });
  group.clear();
}

