/** The scene of a shot in 3D as the studio tells it; the same values as web_studio/stage_values.py. */

/** Metres, Z up. */
export type Point = [number, number, number];
export type FloorPoint = [number, number];

export interface CameraKey {
  frame: number;
  world: number[];
  lens: number;
  distance: number;
}

export interface StageCamera {
  shot: string;
  sensor_width: number;
  keys: CameraKey[];
  hidden: string[];
  f_number: number;
  focus: string[];
}

export interface PlacedThing {
  name: string;
  location: Point;
  rotation: number;
  rests: "floor" | "surface" | "hangs";
  carries: string[];
  model: string;
}

export interface Pose {
  posture: string;
  on: string;
  holding: string[];
  looking_at: string;
}

export interface PersonOnStage {
  name: string;
  start: Point;
  end: Point;
  rotation: number;
  walks: FloorPoint[][];
  via: FloorPoint[];
  start_pose: Pose;
  end_pose: Pose;
  /** The mark that is nearer to where they are at the moment shown; the page finds it. */
  now?: "start" | "end";
}

export interface LampOnStage {
  kind: string;
  location: Point;
  target: Point;
  power: number;
  color: Point;
}

export interface Stage {
  shot: string;
  model: string;
  frame: number;
  frames: number;
  fps: number;
  aspect: number;
  cameras: StageCamera[];
  setting: string[];
  placed: Record<string, PlacedThing>;
  people: Record<string, PersonOnStage>;
  lamps: Record<string, LampOnStage>;
  poses: Record<"sit" | "lie" | "hold" | "look", Record<string, string>>;
  locked: string[];
}
