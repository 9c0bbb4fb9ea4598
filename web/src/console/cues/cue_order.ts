/** Which cue comes beside which: the next one to stand by, the one that a moved cue comes behind, those that are searched. */

import type { Cue } from "../../link/messages";

type Way = -1 | 1;

/** The cue that stands by one key further; those that are skipped are passed by. Null where there is none. */
export function standbyBeside(cues: readonly Cue[], standby: string | null, way: Way): Cue | null {
  const at = cues.findIndex(({ identity }) => identity === standby);
  if (at < 0) return cues.findLast(({ skip }) => !skip) ?? null;
  const others = way < 0 ? cues.slice(0, at).toReversed() : cues.slice(at + 1);
  return others.find(({ skip }) => !skip) ?? null;
}

/** The cue before or behind another; null where there is none. */
export function cueBeside(cues: readonly Cue[], identity: string, way: Way): Cue | null {
  const at = cues.findIndex((cue) => cue.identity === identity);
  return at < 0 ? null : (cues[at + way] ?? null);
}

/** Behind which cue one comes that is moved by a place, "" for the first place; null where it cannot go further. */
export function movedBehind(cues: readonly Cue[], identity: string, way: Way): string | null {
  const at = cues.findIndex((cue) => cue.identity === identity);
  if (at < 0 || cues[at + way] === undefined) return null;
  return way > 0 ? (cues[at + 1]?.identity ?? null) : (cues[at - 2]?.identity ?? "");
}

/** Whether every word of a search stands somewhere in a cue: number, label, note, parts, where these go, and what it does. */
export function isFound(cue: Cue, search: string): boolean {
  const moves = Object.entries(cue.moves).flatMap(([part, { goal }]) => [part, ...Object.keys(goal)]);
  const actions = cue.actions.flatMap(({ does, to, what }) => [does, to, what]);
  const text = [cue.number, cue.label, cue.note, cue.colour, ...moves, ...actions].join("\n").toLowerCase();
  return search
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
}
