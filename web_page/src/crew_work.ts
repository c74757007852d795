/** Events of the crew told together: one piece of work for each thing that a role decides. */

import type { CrewEvent } from "./messages";

export interface Work {
  role: string;
  subject: string;
  /** What it proposes, as data. */
  proposal: string;
  /** Of every turn, 1 to 10. */
  scores: number[];
  /** What the critic minded. */
  remarks: string[];
  /** What was mended. */
  fixes: string[];
  warnings: string[];
  /** Which answerer of a role took over from one that could not go on. */
  handed: boolean;
  done: boolean;
}

/** Return the work that events tell of, the newest last. */
export function worksOf(events: CrewEvent[]): Work[] {
  const works: Work[] = [];
  for (const event of events) {
    if (event.kind === "stage") continue;
    let work = [...works].reverse().find((each) => each.role === event.role && each.subject === (event.subject ?? "") && !each.done);
    if (!work) {
      work = { role: event.role, subject: event.subject ?? "", proposal: "", scores: [], remarks: [], fixes: [], warnings: [], handed: false, done: false };
      works.push(work);
    }
    tell(work, event);
  }
  return works;
}

function tell(work: Work, event: CrewEvent): void {
  const said = [...(event.message ? [event.message] : []), ...(event.details ?? [])];
  if (event.kind === "propose") work.proposal = event.message ?? "";
  else if (event.kind === "score") {
    if (event.score != null) work.scores.push(event.score);
    work.remarks.push(...said);
  } else if (event.kind === "refine") {
    work.fixes.push(...(event.details ?? []));
    work.proposal = event.message ?? work.proposal;
  } else if (event.kind === "handover") work.handed = true;
  else if (event.kind === "warning") {
    work.warnings.push(...said);
    work.done = true;
  } else if (event.kind === "accept") work.done = true;
}
