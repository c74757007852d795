/** What the studio says to the page; the same values as web_studio/messages.py. */

export interface PanelCard {
  shot: string;
  scene: string;
  facts: string;
  seconds: number;
  words: string;
  script: [string, string][];
  picture: string;
  state: "fresh" | "preview" | "stale" | "none";
  omitted: boolean;
  approved: boolean;
  notes: number;
  locked: boolean;
  takes: number;
  problems: number;
}

export interface SceneCard {
  scene: string;
  title: string;
  omitted: boolean;
  shots: PanelCard[];
}

export interface Board {
  project: string;
  title: string;
  revision: string;
  made: boolean;
  aspect: number;
  aspects: Record<string, number>;
  sensor_width: number;
  sensors: Record<string, number>;
  lens_kit: number[];
  summary: string;
  scenes: SceneCard[];
  cast: Record<string, string>;
  undo: string;
  redo: string;
  film: string;
}

export interface Status {
  busy: boolean;
  work: string;
  film: boolean;
  stage: string;
  step: number;
  total: number;
  error: string;
}

export interface Places {
  scripts: string[];
  projects: string[];
  status: Status;
}

export interface CrewEvent {
  kind: string;
  role: string;
  subject?: string;
  turn?: number;
  score?: number | null;
  message?: string;
  details?: string[];
  step?: number | null;
  total?: number | null;
}

export interface Take {
  number: number;
  in_film: boolean;
  camera: string;
  decided: string[];
}

export interface Note {
  number: number;
  text: string;
  author: string;
  resolved: boolean;
}

export interface LineTime {
  line: number;
  person: string;
  at: number;
  seconds: number;
  decided: boolean;
}

export interface ShotDetails {
  shot: string;
  heading: string;
  camera: string;
  seconds: number;
  description: string;
  size: string;
  kind: string;
  angle: string;
  movement: string;
  lens: number;
  f_number: number | null;
  shows: string[];
  on_stage: string[];
  lines: { kind: string; text: string; speaker: string }[];
  decided: string[];
  takes: Take[];
  blocking_takes: Take[];
  layout_takes: Take[];
  scene_decided: string[];
  locked: string[];
  approved: boolean;
  notes: Note[];
  problems: string[];
  speech: LineTime[];
  focus: string[];
  names: Record<string, string>;
  split: { shortest: number; first: number; last: number; lines: number[] };
}

export interface RoleReason {
  role: string;
  subject: string;
  by: "rules" | "model";
  score: number | null;
  turns: number;
  remarks: string[];
  fixes: string[];
  warnings: string[];
}

export interface WordsRead {
  line: number;
  start: number;
  end: number;
  kind: string;
  what: string;
  rule: string;
}

export interface ShotReasons {
  shot: string;
  decided: string[];
  roles: RoleReason[];
  lines: string[];
  words: WordsRead[];
}

export interface ShotChange {
  kind: "new" | "changed" | "moved" | "omitted";
  shot: string;
  former: string;
  words: string;
  former_words: string;
}

export interface ScriptChanges {
  shots: ShotChange[];
  renamed: Record<string, string>;
  lost: [string, string][];
  kept_scenes: string[];
  scenes: number;
}

export interface CutSpeech {
  start: number;
  end: number;
  speaker: string;
  words: string;
}

export interface CutShot {
  shot: string;
  scene: string;
  title: string;
  frames: number;
  held: string;
  speech: CutSpeech[];
}

export interface Cut {
  fps: number;
  shots: CutShot[];
  stale: string[];
}

export interface LampValue {
  name: string;
  kind: string;
  power: number;
  color: number[];
}

export interface SceneDetails {
  scene: string;
  title: string;
  shots: string[];
  kit: string;
  kits: { key: string; name: string }[];
  options: Record<string, boolean>;
  walls: string | null;
  ground: string | null;
  surfaces: Partial<Record<"walls" | "ground", string>>;
  repeats: Partial<Record<"walls" | "ground", number>>;
  materials: string[];
  period: string;
  snow: boolean;
  time_of_day: string;
  weather: string;
  qualities: string[];
  warmth: number;
  brightness: number;
  contrast: number;
  key_side: string;
  lamps: LampValue[];
  panorama: string;
  panorama_rests: boolean;
  outdoors: boolean;
  panoramas: string[];
  words: Record<"time_of_day" | "weather" | "qualities" | "period", string[]>;
  decided: string[];
  locked: string[];
}

export interface AssetCard {
  asset: string;
  name: string;
  sort: "person" | "thing" | "furniture";
  told: string;
  decided: boolean;
  locked: boolean;
  stand_in: boolean;
  picture: string;
}

export interface LookChoices {
  skins: Record<string, string>;
  hair: Record<string, string>;
  garments: { key: string; name: string; on: string; colors: string[] }[];
  finishes: Record<string, string>;
}

export interface LibraryCard {
  digest: string;
  name: string;
  kind: string;
  source: string;
  author: string;
  licence: string;
  url: string;
  megabytes: number;
  used: string[];
  file: string;
  picture: string;
}

export interface ShownLibrary {
  cards: LibraryCard[];
  found: number;
  figures: string;
}

export interface Cast {
  cards: AssetCard[];
  choices: LookChoices;
}

export interface LookNow {
  gender: string;
  age: number;
  stature: number;
  build: string;
  skin: string;
  hair: string;
  hair_color: string;
  facial_hair: string;
  glasses: boolean;
  face: number;
  species: string;
  garments: { key: string; name: string; color: string }[];
}

export interface AssetDetails extends Omit<AssetCard, "picture"> {
  description: string;
  shown_in: { scene: string; title: string; shots: string[] }[];
  source: string;
  made_from: string;
  dimensions: [number, number, number];
  match: number | null;
  credit: { author: string; license: string; copyright: string; url: string } | null;
  image_prompt: string;
  decisions: string[];
  color: string;
  painted: boolean;
  look: LookNow | null;
  front: string;
  top: string;
}

export interface Candidate {
  digest: string;
  model: string;
  file: string;
  name: string;
  source: string;
  credit: string;
  score: number;
  chosen: boolean;
  picture: string;
}

export interface PictureCard {
  file: string;
  entry: string;
  named: string;
  name: string;
  source: string;
  credit: string;
  picture: string;
}

export interface OfferedCard {
  file: string;
  name: string;
  source: string;
  credit: string;
  url: string;
  megabytes: number;
  score: number;
  chosen: boolean;
  picture: string;
}

export interface ShownOffers {
  services: string[];
  waiting: string[];
  failures: string[];
  cards: OfferedCard[];
}

export interface StagingCard {
  number: number;
  picture: string;
  moved: string;
}

export interface PullConflict {
  id: string;
  words: string;
  project: string[];
  compiled: string;
  saved: string;
}

export interface Pulled {
  files: string[];
  understood: string[];
  conflicts: PullConflict[];
  kept: string[];
}

export interface News {
  news: "board" | "status" | "event" | "frames" | "blender";
  revision?: string;
  status?: Status;
  event?: CrewEvent;
  shots?: string[];
}

/** A typed edit, as docs/edits.md lists them. */
export type Edit = { kind: string } & Record<string, unknown>;
