/** The parts that are recorded next: what a press on one makes of them. */

import { CLIP_PARTS } from "../../link/constants";

type Part = (typeof CLIP_PARTS)[number];
/** `only`: this part alone; `beside`: with the others, or without; `touch`: of all this one alone, else as beside. */
export type Arming = "only" | "beside" | "touch";

/** The parts that are armed after a press; by touch, which knows no Shift, all where none would be left. */
export function armedAfter(armed: ReadonlySet<Part>, part: Part, how: Arming): ReadonlySet<Part> {
  const all = armed.size === CLIP_PARTS.length;
  if (how === "only" || (how === "touch" && all)) return new Set([part]);
  const left = CLIP_PARTS.filter((each) => armed.has(each) !== (each === part));
  return new Set(how === "touch" && left.length === 0 ? CLIP_PARTS : left);
}

/** What a click on a part means; `coarse`: where fingers point. */
export const armingOf = (event: Pick<MouseEvent, "shiftKey" | "ctrlKey" | "metaKey">, coarse: boolean): Arming =>
  event.shiftKey || event.ctrlKey || event.metaKey ? "beside" : coarse ? "touch" : "only";
