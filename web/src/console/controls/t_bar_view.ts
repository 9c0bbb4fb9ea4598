/** What a T-bar shows: its hand, the value of the call, and whether the hand has the call. */

import type { CallState } from "../../link/messages";

export interface BarView {
  readonly target: string | null;
  /** Where the call is on the bar's travel, 0 at the bottom. */
  readonly value: number;
  /** `idle`: nothing runs; `running`: by time; `waiting`: the hand must first meet the value; `held`: it has the call. */
  readonly mode: "idle" | "running" | "waiting" | "held";
  /** The call runs from the top to the bottom. */
  readonly flipped: boolean;
  /** Hand above value. */
  readonly gap: number;
}

/** How near a hand counts as having met the value. */
const MEET = 0.02;

/** The view of a bar whose hand stands at `hand`, a moment after `before`; `touched`: a hand of this console is on it. */
export function barView(call: CallState | null, hand: number, touched: boolean, before: BarView | null): BarView {
  if (call === null) return { target: null, value: hand, mode: "idle", flipped: false, gap: 0 };
  const last = before?.target === call.target ? before : null;
  const gap = hand - call.pickup;
  return {
    target: call.target,
    value: call.pickup,
    mode: call.by_hand ? modeByHand(gap, last) : touched ? "waiting" : "running",
    flipped: isFlipped(call, last?.flipped ?? false),
    gap,
  };
}

/** The engine turns the ends of a bar that was left at the top: then the pickup runs against the progress. */
function isFlipped(call: CallState, before: boolean): boolean {
  const along = Math.abs(call.pickup - call.progress);
  const against = Math.abs(call.pickup - (1 - call.progress));
  return Math.abs(along - against) < 1e-9 ? before : against < along;
}

function modeByHand(gap: number, last: BarView | null): BarView["mode"] {
  const met = Math.abs(gap) <= MEET || (last !== null && gap * last.gap < 0);
  // a timed call is by hand only once the hand has it; and the value may glide after a fast hand without being lost
  return met || last?.mode === "held" || last?.mode === "running" ? "held" : "waiting";
}
