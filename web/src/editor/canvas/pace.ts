/** What the canvas measures of itself: frames, and how long hands wait for the other faces. */

import type { Difference } from "./figure";

export interface Counters {
  /** Frames drawn. */
  drawn: number;
  /** Milliseconds between the last frames drawn, newest last. */
  intervals: number[];
  /** Milliseconds from pointer events to the end of the frame in which the other faces followed, newest last. */
  waits: number[];
  /** The last difference between a face's linearised and true shape, by face, metres. */
  differences: Record<string, Difference>;
  /** Times that a face took a true shape. */
  arrived: number;
  fps: number;
}

const KEPT = 600;

export class Pace {
  drawn = 0;
  readonly intervals: number[] = [];
  readonly waits: number[] = [];
  private last: number | undefined;
  private touched: number | undefined;
  private readonly awaited: { since: number; done: () => boolean }[] = [];

  /** A hand moved something at this time (ms). */
  moved(since: number): void {
    this.touched ??= since;
  }

  /** A frame was drawn at this time (ms); `followed`: the other faces have moved in it; `done`: whether it is finished. */
  frame(time: number, followed: boolean, done: () => boolean): void {
    this.drawn += 1;
    if (this.last !== undefined) push(this.intervals, time - this.last);
    this.last = time;
    if (this.touched === undefined || !followed) return;
    this.awaited.push({ since: this.touched, done });
    this.touched = undefined;
  }

  /** No frame was drawn: the next interval counts from the next frame. */
  idle(): void {
    this.last = undefined;
  }

  /** Looks which frames are finished at this time (ms). */
  look(time: number): void {
    while (this.awaited[0]?.done()) {
      const { since } = this.awaited.shift() as { since: number };
      push(this.waits, time - since);
    }
  }

  /** Frames in a second, of the last dozen. */
  get fps(): number {
    const recent = this.intervals.slice(-12);
    return recent.length === 0 ? 0 : (1000 * recent.length) / recent.reduce((sum, each) => sum + each, 0);
  }
}

function push(list: number[], value: number): void {
  list.push(value);
  if (list.length > KEPT) list.shift();
}
