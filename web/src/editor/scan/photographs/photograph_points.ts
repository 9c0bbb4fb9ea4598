/** The landmarks of photographs as people correct them: undo and redo. It touches neither page nor server. */

import { PointHistory } from "../data/point_history";
import { moveHandle } from "./photograph_handles";

/** A photograph of the desk in which a face was found. */
export interface FoundPhotograph {
  /** What it is called on the desk, and where it goes. */
  readonly name: string;
  readonly file: string;
  /** Without anything but its pixels, and where a page shows it from. */
  readonly picture: Blob;
  readonly address: string;
  readonly width: number;
  readonly height: number;
  /** x and y in parts of width and height, depth in widths, of each. */
  readonly points: Float32Array;
}

/** The points of all photographs as they are now. */
export class PhotographPoints extends PointHistory<readonly Float32Array[]> {
  constructor(readonly all: readonly FoundPhotograph[]) {
    super(all.map(({ points }) => points));
  }

  /** The points of a photograph as they are now. */
  of(photograph: number): Float32Array {
    return this.now[photograph] as Float32Array;
  }

  /** Whether a fit would now be by other points than that which is shown. */
  get changed(): boolean {
    return this.now.some((points, at) => points !== this.fittedBy[at]);
  }

  /** Moves a handle of a photograph by parts of it; what follows within one drag is one step: `same`. */
  move(photograph: number, handle: number, by: readonly [number, number], same = false): void {
    const { width, height } = this.all[photograph] as FoundPhotograph;
    const base = same ? (this.past.at(-1) ?? this.now) : this.now; // a drag begins where the hand took hold
    const moved = moveHandle(base[photograph] as Float32Array, handle, by, width / height);
    this.put(
      this.now.map((points, at) => (at === photograph ? moved : points)),
      same,
    );
  }
}
