/** Two runs laid over one another: what charts draw of them, and where a time of the page is in each. */

import type { CalledCue } from "../../link/messages";
import type { Note, Run } from "../recordings";
import {
  type Anchor,
  type CuePair,
  type Difference,
  differencesOf,
  GRID,
  onGrid,
  overA,
  pairCues,
  type Shift,
  shiftsOf,
  underA,
} from "./alignment";
import type { Quantity } from "./choices";
import type { Curves } from "./curves";
import type { Drawn, Mark } from "./run_chart";
import type { View } from "./view";

/** One of the two: what was recorded of it. */
export interface Side {
  run: Run;
  curves: Curves;
  cues: CalledCue[];
}

export class Comparison {
  readonly pairs: CuePair[];
  readonly differences: Difference[];
  /** Seconds of A, on the grid. */
  readonly times: number[];
  readonly whole: View;
  readonly #shifts: Shift[];

  constructor(
    readonly a: Side,
    readonly b: Side,
    anchor: Anchor,
  ) {
    this.pairs = pairCues(a.cues, b.cues);
    this.differences = differencesOf(this.pairs, anchor);
    this.#shifts = shiftsOf(this.pairs, anchor);
    const moved = [0, b.run.seconds].flatMap((at) => overA(this.#shifts, at) ?? []);
    const first = Math.floor(Math.min(0, ...moved) * GRID);
    const last = Math.ceil(Math.max(a.run.seconds, ...moved) * GRID);
    this.times = Array.from({ length: Math.max(last - first, GRID) + 1 }, (_, place) => (first + place) / GRID);
    this.whole = { min: this.times[0] ?? 0, max: this.times.at(-1) ?? 1 };
  }

  /** Who is in either, in the order of A. */
  get characters(): string[] {
    return [...new Set([...Object.keys(this.a.curves.characters), ...Object.keys(this.b.curves.characters)])];
  }

  /** What is drawn of a character in one of the runs. */
  drawn(of: "a" | "b", character: string, { key, words }: Quantity): Drawn {
    const { times, characters } = this[of].curves;
    const curves = characters[character];
    const lay = <Value>(column: (Value | null)[]): (Value | null)[] =>
      onGrid(
        times,
        column,
        this.whole.min,
        this.times.length,
        of === "a" ? undefined : (at) => overA(this.#shifts, at),
      );
    const drawn: Drawn = { values: lay(curves?.values[key] ?? []) };
    return words === undefined || curves === undefined ? drawn : { ...drawn, words: lay(curves[words]) };
  }

  /** Cues and notes as lines; where both have called a cue at one place, one line. */
  marks(notes: readonly Note[]): Mark[] {
    const marks: Mark[] = this.a.cues.map(({ at, number }) => ({ at, label: number, of: "a" }));
    for (const { at, number } of this.b.cues) {
      const over = overA(this.#shifts, at);
      const same = marks.some((mark) => mark.label === number && over !== undefined && Math.abs(mark.at - over) < 0.05);
      if (over !== undefined && !same) marks.push({ at: over, label: number, of: "b" });
    }
    for (const note of notes) {
      const at = this.placeOf(note);
      if (at !== undefined) marks.push({ at, label: "", of: "note" });
    }
    return marks;
  }

  /** Where a note of either run lies on the page. */
  placeOf({ start, at }: Note): number | undefined {
    const inside = ({ run }: Side): boolean =>
      run.file === 0 && run.start === start && at >= run.first && at <= run.first + run.seconds;
    if (inside(this.a)) return at - this.a.run.first;
    return inside(this.b) ? overA(this.#shifts, at - this.b.run.first) : undefined;
  }

  /** The moment of a run that lies at a time of the page; undefined where none does. */
  momentOf(of: "a" | "b", time: number): number | undefined {
    const at = of === "a" ? time : underA(this.#shifts, time);
    return at === undefined || at < 0 || at > this[of].run.seconds ? undefined : at;
  }

  /** Where a cue lies on the page: in A, else in B. */
  cuePlace({ a, b }: CuePair): number | undefined {
    return a ?? (b === undefined ? undefined : overA(this.#shifts, b));
  }
}
