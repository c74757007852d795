/** Where shots lie on the timeline, and what is seen and said at a frame of the film. */

import type { Cut, CutShot, CutSpeech } from "./messages";

/** A shot with its place on the timeline, in frames of the film. */
export interface Placed extends CutShot {
  start: number;
}

/** The shots in order with their starts; one that is being trimmed has the length that it would get. */
export function placed(cut: Cut, trim: { shot: string; frames: number } | null): Placed[] {
  let start = 0;
  return cut.shots.map((shot) => {
    const frames = trim?.shot === shot.shot ? trim.frames : shot.frames;
    const here = { ...shot, frames, start };
    start += frames;
    return here;
  });
}

/** The shot at a frame of the film; the last one at its end. */
export function shotAt(shots: Placed[], frame: number): Placed | undefined {
  return shots.filter((shot) => shot.start <= frame).at(-1);
}

/** Who speaks at a frame of the film. */
export function speechAt(shot: Placed | undefined, frame: number): CutSpeech | undefined {
  return shot?.speech.find((each) => shot.start + each.start <= frame && frame < shot.start + each.end);
}

/** ``00:01:02:03``: hours, minutes, seconds, frames. */
export function timecode(frame: number, fps: number): string {
  const seconds = Math.floor(frame / fps);
  const parts = [seconds / 3600, (seconds / 60) % 60, seconds % 60, frame % fps];
  return parts.map((part) => String(Math.floor(part)).padStart(2, "0")).join(":");
}
