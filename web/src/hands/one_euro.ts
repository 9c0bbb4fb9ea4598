/**
 * The One-Euro filter: what is still is held still, what moves fast follows at once.
 * Source: G. Casiez, N. Roussel, D. Vogel, 1 Euro Filter, CHI 2012; the cut-off grows by the square of the speed here,
 * which parts the tremble of a hand at rest from speech better.
 */

/** Cut-off at rest, Hz; Hz more for a unit a second, by its square; cut-off of the speed, Hz. */
const [CALM, LIVELY, SLOPE] = [2, 5, 2];
/** Seconds; after more it begins anew. */
const LONGEST_GAP = 0.5;

const share = (cutOff: number, gap: number): number => {
  const turn = 2 * Math.PI * cutOff * gap;
  return turn / (turn + 1);
};

/** Filters many values at once, each by its own speed. */
export class OneEuroFilter {
  #time = Number.NEGATIVE_INFINITY;
  #values: number[] = [];
  #speeds: number[] = [];

  /** The filtered values at a time, seconds; a clock that jumps, or a gap, begins anew. */
  follow(values: readonly number[], time: number): number[] {
    const gap = time - this.#time;
    this.#time = time;
    if (!(gap > 0 && gap <= LONGEST_GAP)) {
      this.#values = [...values];
      this.#speeds = values.map(() => 0);
      return this.#values;
    }
    this.#speeds = this.#speeds.map((speed, place) => {
      const now = ((values[place] ?? 0) - (this.#values[place] ?? 0)) / gap;
      return speed + share(SLOPE, gap) * (now - speed);
    });
    this.#values = this.#values.map((value, place) => {
      const cutOff = CALM + LIVELY * (this.#speeds[place] ?? 0) ** 2;
      return value + share(cutOff, gap) * ((values[place] ?? 0) - value);
    });
    return this.#values;
  }
}
