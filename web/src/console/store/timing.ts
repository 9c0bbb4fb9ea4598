/** How a call is timed: the seconds and the easing chosen for an axis. */

import type { EASING_NAMES } from "../../link/constants";

/** Seconds of a call; `null`: by hand, the T-bar moves it. */
export type Seconds = number | null;

/** The seconds stay while calls are by hand, so that they are there again afterwards. */
export interface Timing {
  readonly seconds: number;
  readonly easing: string;
  readonly byHand: boolean;
}

export const CHOICES: readonly number[] = [0, 0.25, 0.5, 1, 2, 4, 8];
/** Those of a list, which has room. */
export const MANY_CHOICES: readonly number[] = [0, 0.25, 0.5, 1, 1.5, 2, 3, 4, 6, 8, 12, 20, 30, 60];
/** The longest call that can be typed. */
export const LONGEST = 600;

/** The words on a button: `cut`, `.25`, `2`, `hand`. */
export function secondsLabel(seconds: Seconds): string {
  if (seconds === null) return "hand";
  if (seconds === 0) return "cut";
  return String(Number(seconds.toFixed(2))).replace(/^0\./, ".");
}

/** What a person typed as seconds (point or comma), or a sentence that says what is expected. */
export function parseSeconds(text: string): number | string {
  const clean = text.trim().replace(",", ".").replace(/s$/, "");
  const value = Number(clean);
  if (clean === "" || !Number.isFinite(value) || value < 0 || value > LONGEST)
    return `"${text}" is not a duration: type seconds from 0 to ${LONGEST}, for example 1.5.`;
  return value;
}

/** The neighbouring choice, shorter (-1) or longer (+1); from `by hand` back to the seconds of before. */
export function neighbour({ seconds, byHand }: Pick<Timing, "seconds" | "byHand">, direction: -1 | 1): number {
  if (byHand) return seconds;
  const candidates = CHOICES.filter((choice) => (direction < 0 ? choice < seconds : choice > seconds));
  return (direction < 0 ? candidates.at(-1) : candidates[0]) ?? seconds;
}

/** The time left, for the eye: `1.4`, `12`, and nothing at the end. */
export function remainingLabel(seconds: number): string {
  return seconds >= 10 ? seconds.toFixed(0) : seconds.toFixed(1);
}

export type EasingName = (typeof EASING_NAMES)[number];

/** Each easing of the engine as the way of a small curve in a box of 20 x 12. */
export const EASING_CURVES: Readonly<Record<EasingName, string>> = {
  smooth: "M1 11C10 11 10 1 19 1",
  gentle: "M1 11C7 11 13 1 19 1",
  sharp: "M1 11C12 11 8 1 19 1",
  early: "M1 11C4 11 4 1 19 1",
  late: "M1 11C16 11 16 1 19 1",
};
