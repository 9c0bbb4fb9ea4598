/** The two axes of a call, and what runs on each. */

import type { CallState, State } from "../../link/messages";

/** What is called and mixed: faces, and expressions. */
export type Axis = "face" | "expression";

/** The call that runs on an axis. */
export function callOf(state: State, axis: Axis): CallState | null {
  return axis === "face" ? state.face_call : state.expression_call;
}

/** Where the T-bar of an axis stands, 0..1. */
export function faderOf(state: State, axis: Axis): number {
  return axis === "face" ? state.face_fader : state.expression_fader;
}

/** The end of its travel that a T-bar in the middle goes to, as the engine turns a call round; null at an end. */
export function endFrom(stands: number): 0 | 1 | null {
  const end = stands > 0.5 ? 1 : 0;
  return stands === end ? null : end;
}

/** What a console knows of an axis by following it: when a hand elsewhere last moved its bar, and whether its call has
 * seconds of its own to run on in; null where it was not there from the call's beginning. */
export interface Followed {
  readonly movedElsewhere: number;
  readonly timed: boolean | null;
}

export const UNKNOWN: Followed = { movedElsewhere: Number.NEGATIVE_INFINITY, timed: null };

/** What is known after `state`, which came after `last`; `own`: a hand of this console moves the bar. */
export function follow(before: Followed, axis: Axis, [last, state]: [State | null, State], own: boolean, now: number) {
  const moved = last !== null && faderOf(last, axis) !== faderOf(state, axis) && !own;
  const [old, call] = [last === null ? null : callOf(last, axis), callOf(state, axis)];
  const same = old !== null && call !== null && isSame(old, call);
  const first = last === null ? null : false; // one by hand from its beginning has no seconds
  const timed = call === null ? null : !call.by_hand ? true : same ? before.timed : first;
  return { movedElsewhere: moved ? now : before.movedElsewhere, timed };
}

/** Whether two reports tell of one call: another to the same target leaves another mix. */
const isSame = (one: CallState, other: CallState): boolean =>
  one.target === other.target &&
  Object.keys({ ...one.start, ...other.start }).every((name) => one.start[name] === other.start[name]);

/** The names on air, heaviest first; weights below a thousandth are not shown. */
export function onAir(weights: Readonly<Record<string, number>>): [string, number][] {
  return Object.entries(weights)
    .filter(([, weight]) => Math.abs(weight) >= 0.001)
    .sort(([a, x], [b, y]) => y - x || a.localeCompare(b));
}

/** Lines that a mix is named in; of more names the last line counts the rest. */
const LINES = 3;

/** A mix in words, a line for each name with its weight in per cent: `Cat 52`, `Goblin 48`; one alone needs no number. */
export function mixLabel(weights: Readonly<Record<string, number>>, label: (name: string) => string): string {
  const names = onAir(weights);
  const [first] = names;
  if (first === undefined) return "";
  const per = ([name, weight]: [string, number]): string => `${label(name)} ${Math.round(weight * 100)}`;
  if (names.length === 1 || first[1] >= 0.995) return label(first[0]);
  if (names.length <= LINES) return names.map(per).join("\n");
  return [...names.slice(0, LINES - 1).map(per), `+ ${names.length - LINES + 1} more`].join("\n");
}
