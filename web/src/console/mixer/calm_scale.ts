/** Smoothing as one control: 0 calm, 1 lively; between them seconds that shrink by the same factor with each step. */

/** Seconds in which a step is followed, at both ends: what the show takes, and two of its ticks. */
const CALMEST = 2;
const LIVELIEST = 0.03;
/** What a source is followed in that asks for nothing, as its layer is (`columns.py`). */
const USUAL = 0.12;

const lively = (seconds: number): number => Math.log(seconds / CALMEST) / Math.log(LIVELIEST / CALMEST);

/** Where the control stands for some seconds; 0 seconds: as usual. */
export function livelinessOf(seconds: number): number {
  if (seconds === 0) return lively(USUAL);
  return Math.min(1, Math.max(0, lively(seconds)));
}

/** The seconds of a place of the control; `null`: as usual, which is 0 seconds. */
export function secondsOf(liveliness: number | null): number {
  if (liveliness === null) return 0;
  return Number((CALMEST * (LIVELIEST / CALMEST) ** liveliness).toFixed(3));
}

/** In words: seconds of a step. */
export const smoothingWords = (seconds: number): string => (seconds === 0 ? "usual" : `${seconds.toFixed(2)} s`);
