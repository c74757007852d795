/**
 * What can be chosen on the stage, where it is, and the edit that puts it elsewhere.
 *
 * An item is a node id of a thing or a person, or `lamp:NAME`, `lamp-aim:NAME`, `camera:SHOT:start`, `aim:SHOT:end`,
 * `mark:PERSON:start`, `via:PERSON:0`.
 */

import type { Edit } from "./messages";
import { type CameraPose, keyOf, poseOf, roundTo, travels } from "./stage_cameras";
import type { FloorPoint, Point, Stage, StageCamera } from "./stage_values";

type End = "start" | "end";
/** Metres that a person goes at least who goes somewhere. */
const GOES = 0.05;

export function partsOf(item: string): [kind: string, id: string, part: string] {
  const [kind, id, part] = item.split(":");
  return id === undefined ? ["node", kind, ""] : [kind, id, part ?? ""];
}

/** What an item is called; empty where there is no such item. */
export function nameOf(stage: Stage, item: string): string {
  const [kind, id, part] = partsOf(item);
  const person = stage.people[id]?.name ?? id;
  const shot = id.slice(-5);
  switch (kind) {
    case "node":
      return (stage.placed[id] ?? stage.people[id])?.name ?? "";
    case "lamp":
      return id in stage.lamps ? id.replaceAll("_", " ") : "";
    case "lamp-aim":
      return id in stage.lamps ? `Where ${id.replaceAll("_", " ")} points` : "";
    case "camera":
      return cameraOf(stage, id) ? `Camera ${shot}${part === "end" ? ", at the end" : ""}` : "";
    case "aim":
      return cameraOf(stage, id) ? `What camera ${shot} looks at` : "";
    case "mark":
      return id in stage.people ? `${person}: ${part === "start" ? "begins" : "ends"} here` : "";
    default:
      return stage.people[id]?.via[Number(part)] ? `${person}: goes through here` : "";
  }
}

/** Where an item is. */
export function spotOf(stage: Stage, item: string): Point | null {
  const [kind, id, part] = partsOf(item);
  switch (kind) {
    case "node":
      return stage.placed[id]?.location ?? stage.people[id]?.[endAt(stage, id)] ?? null;
    case "lamp":
      return stage.lamps[id]?.location ?? null;
    case "lamp-aim":
      return stage.lamps[id]?.target ?? null;
    case "mark":
      return stage.people[id]?.[part as End] ?? null;
    case "via": {
      const point = stage.people[id]?.via[Number(part)];
      return point ? [...point, 0] : null;
    }
    default: {
      const camera = cameraOf(stage, id);
      return camera ? poseOf(camera, part as End)[kind === "camera" ? "location" : "target"] : null;
    }
  }
}

/** Degrees that a thing or a person is turned; null for what is not turned so. */
export function turnOf(stage: Stage, item: string): number | null {
  return (stage.placed[item] ?? stage.people[item])?.rotation ?? null;
}

/** Put an item elsewhere in a stage; the stage is changed. */
export function put(stage: Stage, item: string, to: Point): void {
  const [kind, id, part] = partsOf(item);
  const spot = to.map((value) => roundTo(value, 3)) as Point;
  switch (kind) {
    case "node":
      if (id in stage.placed) stage.placed[id].location = spot;
      else putPerson(stage, id, spot);
      return;
    case "lamp":
      stage.lamps[id].location = spot;
      return;
    case "lamp-aim":
      stage.lamps[id].target = spot;
      return;
    case "mark":
      stage.people[id][part as End] = spot;
      return;
    case "via":
      stage.people[id].via[Number(part)] = [spot[0], spot[1]];
      return;
    default:
      putCamera(stage, id, part as End, { [kind === "camera" ? "location" : "target"]: spot });
  }
}

/** Who goes nowhere ends where they begin. */
function putPerson(stage: Stage, id: string, spot: Point): void {
  const person = stage.people[id];
  const stays = Math.hypot(person.end[0] - person.start[0], person.end[1] - person.start[1]) < GOES;
  person[endAt(stage, id)] = spot;
  if (stays) person.end = [...spot];
}

/** Change where a camera stands at one end of its shot; the stage is changed. */
export function putCamera(stage: Stage, shot: string, when: End, change: Partial<CameraPose>): void {
  const camera = cameraOf(stage, shot)!;
  const keys = camera.keys;
  const at = when === "start" ? 0 : keys.length - 1;
  const changed = keyOf({ ...poseOf(camera, when), ...change }, keys[at].frame, keys[at].lens);
  camera.keys = travels(camera) ? (when === "start" ? [changed, keys.at(-1)!] : [keys[0], changed]) : [changed];
}

/** The edit that makes of an item what it is in a stage. `height`: it stays at its height, wherever it is put. */
export function editOf(stage: Stage, item: string, height = false): Edit {
  const [kind, id, part] = partsOf(item);
  const [x, y, z] = spotOf(stage, item)!;
  const scene = stage.shot.slice(0, -6);
  if (kind === "node" && id in stage.placed) {
    return { kind: "place", scene, thing: id, place: { location: [x, y], ...(height ? { height: z } : {}) } };
  }
  if (kind === "lamp" || kind === "lamp-aim") {
    return lampEdit(stage, id, { [kind === "lamp" ? "location" : "target"]: [x, y, z] });
  }
  if (kind === "camera" || kind === "aim") return cameraEdit(stage, id);
  if (kind === "via") return marksEdit(stage, id, { via: stage.people[id].via });
  return marksEdit(stage, id, { [kind === "mark" ? part : endAt(stage, id)]: { location: [x, y] } });
}

export function marksEdit(stage: Stage, person: string, marks: object): Edit {
  return { kind: "blocking", shot: stage.shot, person, marks };
}

export function lampEdit(stage: Stage, name: string, decided: object | null): Edit {
  return { kind: "light", scene: stage.shot.slice(0, -6), decision: { lamps: { [name]: decided } } };
}

/** The edit that has a camera stand where it stands in a stage. */
export function cameraEdit(stage: Stage, shot: string): Edit {
  const camera = cameraOf(stage, shot)!;
  const ends = travels(camera) ? { end: placed(camera, "end") } : {};
  const decision = { placed: { start: placed(camera, "start"), ...ends }, lens: roundTo(camera.keys[0].lens, 1) };
  return { kind: "camera", shot, decision };
}

/** The edit that takes the shot from a pose: as it begins, as it ends, or all the time. */
export function shotFrom(stage: Stage, pose: CameraPose, when: End | "always"): Edit {
  const changed = structuredClone(stage);
  const camera = cameraOf(changed, stage.shot)!;
  const [first, last] = [camera.keys[0], camera.keys.at(-1)!];
  const here = (frame: number) => keyOf(pose, frame, first.lens);
  camera.keys = {
    start: () => [here(0), ...(travels(camera) ? [last] : [{ ...first, frame: Math.max(1, stage.frames - 1) }])],
    end: () => [first, here(Math.max(1, stage.frames - 1))],
    always: () => [here(0)],
  }[when]();
  return cameraEdit(changed, stage.shot);
}

function placed(camera: StageCamera, when: End): CameraPose {
  const { location, target, roll } = poseOf(camera, when);
  return { location: location.map((each) => roundTo(each, 3)) as Point, target: target.map((each) => roundTo(each, 3)) as Point, roll };
}

export function cameraOf(stage: Stage, shot: string): StageCamera | undefined {
  return stage.cameras.find((each) => each.shot === shot);
}

/** The mark of a person that is moved where they are taken hold of. */
export function endAt(stage: Stage, person: string): End {
  return stage.people[person].now ?? "start";
}

/** Note which mark of a person is nearer to where they are; the stage is changed. */
export function noteWhere(stage: Stage, person: string, x: number, y: number): void {
  const { start, end } = stage.people[person];
  const away = ([mx, my]: Point) => Math.hypot(mx - x, my - y);
  const goes = Math.hypot(end[0] - start[0], end[1] - start[1]) > GOES;
  stage.people[person].now = goes && away(end) < away(start) ? "end" : "start";
}

/** Where on the first way of a person a point becomes a way point: the place among those that there are. */
export function placeAmong(stage: Stage, person: string, point: FloorPoint): number {
  const { via, walks } = stage.people[person];
  const along = (spot: FloorPoint) => {
    const far = walks[0].map(([x, y]) => Math.hypot(x - spot[0], y - spot[1]));
    return far.indexOf(Math.min(...far));
  };
  return via.filter((each) => along(each) <= along(point)).length;
}
