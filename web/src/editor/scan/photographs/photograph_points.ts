/** The landmarks of photographs as people correct them: undo and redo. It touches neither page nor server. */

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

type Landmarks = readonly Float32Array[];

export class PhotographPoints {
  readonly all: readonly FoundPhotograph[];
  #now: Landmarks;
  #past: Landmarks[] = [];
  #future: Landmarks[] = [];
  /** The points by which the face that is shown was fitted. */
  #fitted: Landmarks;

  constructor(all: readonly FoundPhotograph[]) {
    this.all = all;
    this.#now = all.map(({ points }) => points);
    this.#fitted = this.#now;
  }

  /** The points of a photograph as they are now. */
  of(photograph: number): Float32Array {
    return this.#now[photograph] as Float32Array;
  }

  get canUndo(): boolean {
    return this.#past.length > 0;
  }

  get canRedo(): boolean {
    return this.#future.length > 0;
  }

  /** Whether a fit would now be by other points than that which is shown. */
  get changed(): boolean {
    return this.#now.some((points, at) => points !== this.#fitted[at]);
  }

  /** Moves a handle of a photograph by parts of it; what follows within one drag is one step: `same`. */
  move(photograph: number, handle: number, by: readonly [number, number], same = false): void {
    if (!same) this.#past.push(this.#now);
    this.#future = [];
    const { width, height } = this.all[photograph] as FoundPhotograph;
    const base = same ? (this.#past.at(-1) ?? this.#now) : this.#now; // a drag begins where the hand took hold
    const moved = moveHandle(base[photograph] as Float32Array, handle, by, width / height);
    this.#now = this.#now.map((points, at) => (at === photograph ? moved : points));
  }

  undo(): void {
    this.#step(this.#past, this.#future);
  }

  redo(): void {
    this.#step(this.#future, this.#past);
  }

  /** What is set now has been fitted. */
  fitted(): void {
    this.#fitted = this.#now;
  }

  #step(from: Landmarks[], to: Landmarks[]): void {
    const points = from.pop();
    if (points === undefined) return;
    to.push(this.#now);
    this.#now = points;
  }
}
