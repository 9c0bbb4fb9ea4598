/** What the canvas measures of itself: finished frames, and how long hands wait for the other faces. */

import type { Difference } from "../model/figure";

export interface CanvasCounters {
  /** Frames finished. */
  drawn: number;
  /** Milliseconds between the last frames finished, newest last. */
  intervals: number[];
  /** Milliseconds from pointer events to the end of the frame in which the other faces followed, newest last. */
  waits: number[];
  /** The last difference between a face's linearised and true shape, by face, metres. */
  differences: Record<string, Difference>;
  /** Times that a face took a true shape. */
  arrived: number;
  fps: number;
}

interface Frame {
  /** When the hand moved what this frame shows first, ms. */
  since: number | undefined;
  done: () => boolean;
}

const KEPT = 2000;

export class FramePacing {
  drawn = 0;
  readonly intervals: number[] = [];
  readonly waits: number[] = [];
  private last: number | undefined;
  private changedRows: number | undefined;
  private drawing: Frame | undefined;

  /** Whether the machine still draws: another frame now would only queue up, and hands would wait for both. */
  get busy(): boolean {
    return this.drawing !== undefined;
  }

  /** A hand moved something at this time (ms). */
  moved(since: number): void {
    this.changedRows ??= since;
  }

  /** A frame was given to the machine; `followed`: the other faces have moved in it; `done`: whether it is finished. */
  frame(followed: boolean, done: () => boolean): void {
    this.drawing = { since: followed ? this.changedRows : undefined, done };
    if (followed) this.changedRows = undefined;
  }

  /** Nothing was to be drawn: the next interval counts from the next frame. */
  idle(): void {
    this.last = undefined;
  }

  /** No frame is waited for any more: of a canvas that has gone none may ever be finished. */
  end(): void {
    this.drawing = undefined;
  }

  /** Looks at this time (ms) whether the frame is finished. */
  look(time: number): void {
    if (this.drawing === undefined || !this.drawing.done()) return;
    const { since } = this.drawing;
    this.drawing = undefined;
    this.drawn += 1;
    if (this.last !== undefined) push(this.intervals, time - this.last);
    this.last = time;
    if (since !== undefined) push(this.waits, time - since);
  }

  /** Goes on as soon as the machine is done, not only when the display asks next: what it is late by is not doubled. */
  whenDone(next: () => void): void {
    setTimeout(() => {
      this.look(performance.now());
      if (this.busy) this.whenDone(next);
      else next();
    });
  }

  /** Frames in a second, of the last dozen. */
  get fps(): number {
    const recent = this.intervals.slice(-12);
    return recent.length === 0 ? 0 : (1000 * recent.length) / recent.reduce((sum, interval) => sum + interval, 0);
  }
}

function push(list: number[], value: number): void {
  list.push(value);
  if (list.length > KEPT) list.shift();
}
