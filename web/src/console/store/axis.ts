/** What is called, and what runs on each axis of a call. */

import type { CallState, CharacterState } from "../../link/messages";

/** What a figure does that nobody has told anything. */
export const STAND = "stand";

/** What is called and mixed: faces, and expressions. */
export type Axis = "face" | "expression";

/** What palettes have tiles of, T-bars move, and pads mix. */
export type LookKind = Axis | "pose";
export const LOOK_KINDS: readonly LookKind[] = ["face", "expression", "pose"];

/** The axis whose seconds a call takes: poses are called from the palette of expressions, in its seconds. */
export const timingOf = (kind: LookKind): Axis => (kind === "pose" ? "expression" : kind);

/** The call that runs on an axis. */
export function callOf(state: CharacterState, axis: LookKind): CallState | null {
  if (axis === "pose") return state.figure?.pose_call ?? null;
  return axis === "face" ? state.face_call : state.expression_call;
}

/** The mix that is on air on an axis; poses: of the whole figure. */
export function mixOf(state: CharacterState, axis: LookKind): Readonly<Record<string, number>> {
  if (axis === "pose") return state.figure?.poses ?? { [STAND]: 1 };
  return axis === "face" ? state.faces : state.expressions;
}

/** Where the T-bar of an axis stands, 0..1. */
export function faderOf(state: CharacterState, axis: LookKind): number {
  if (axis === "pose") return state.figure?.fader ?? 0;
  return axis === "face" ? state.face_fader : state.expression_fader;
}

/** The end of its travel that a T-bar in the middle goes to, as the engine turns a call round; null at an end. */
export function endFrom(stands: number): 0 | 1 | null {
  const end = stands > 0.5 ? 1 : 0;
  return stands === end ? null : end;
}

/** Whether the call of an axis has seconds of its own to run on in, as a console knows by following it: `timed` before,
 * then `state`, which came after `last`. Null where the console was not there from the call's beginning. */
export function followTimed(
  timed: boolean | null,
  axis: LookKind,
  last: CharacterState | null,
  state: CharacterState,
): boolean | null {
  const [old, call] = [last === null ? null : callOf(last, axis), callOf(state, axis)];
  const same = old !== null && call !== null && isSame(old, call);
  const first = last === null ? null : false; // one by hand from its beginning has no seconds
  return call === null ? null : !call.by_hand ? true : same ? timed : first;
}

/** Whether two reports tell of one call: another to the same target leaves another mix. */
const isSame = (call: CallState, other: CallState): boolean =>
  call.target === other.target &&
  Object.keys({ ...call.start, ...other.start }).every((name) => call.start[name] === other.start[name]);

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
