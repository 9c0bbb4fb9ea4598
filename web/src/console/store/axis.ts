/** The two axes of a call, and what runs on each. */

import type { CallState, State } from "../../link/messages";

/** What is called and mixed: faces, and expressions. */
export type Axis = "face" | "expression";

/** The call that runs on an axis. */
export function callOf(state: State, axis: Axis): CallState | null {
  return axis === "face" ? state.face_call : state.expression_call;
}

/** The names on air, heaviest first; weights below a thousandth are not shown. */
export function onAir(weights: Readonly<Record<string, number>>): [string, number][] {
  return Object.entries(weights)
    .filter(([, weight]) => Math.abs(weight) >= 0.001)
    .sort(([a, x], [b, y]) => y - x || a.localeCompare(b));
}
