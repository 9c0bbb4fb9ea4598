/** Interpolates the poses, or the scenes, that arrive to the time that is drawn. */

import { MathUtils } from "three";
/** When a state is due, in server seconds. */
export interface Due {
  time: number;
  epoch: number;
}

const GAP = 0.25; // seconds without a state after which the next one is eased to
const EASE = 0.4; // seconds the easing takes
const KEPT = 64;

/**
 * The states of the last second, to be drawn a little late so that there is one on either side of every frame. `mix` gives
 * what lies part of the way (0..1) from one to the other.
 */
export class Timeline<Shown extends object> {
  private states: (Shown & Due)[] = [];
  private arrived = -Infinity;
  private shown: Shown | undefined;
  private easing: { from: Shown; since: number } | undefined;

  constructor(private readonly mix: (from: Shown, to: Shown, part: number) => Shown) {}

  /** A state that arrived at `local` (our seconds), newer than all before. */
  push(state: Shown & Due, local: number): void {
    const last = this.states.at(-1);
    const jump = last !== undefined && (state.epoch !== last.epoch || local - this.arrived > GAP);
    if (jump && this.shown !== undefined) {
      this.easing = { from: this.shown, since: local };
      this.states = []; // never interpolated across a gap or between two clocks
    }
    this.states.push(state);
    if (this.states.length > KEPT) this.states.shift();
    this.arrived = local;
  }

  /** Seconds since the newest state arrived. */
  silence(local: number): number {
    return local - this.arrived;
  }

  /** What shows at server time `due` at our time `local`: between states a mix, past the newest the newest (held). */
  at(due: number, local: number): Shown | undefined {
    const pose = this.sample(due);
    if (pose !== undefined) this.shown = this.eased(pose, local);
    return this.shown;
  }

  private sample(due: number): Shown | undefined {
    const after = this.states.findIndex((state) => state.time > due);
    if (after < 0) return this.states.at(-1);
    const next = this.states[after] as Shown & Due;
    const before = this.states[after - 1];
    if (before === undefined) return next;
    return this.mix(before, next, (due - before.time) / (next.time - before.time));
  }

  private eased(pose: Shown, local: number): Shown {
    if (this.easing === undefined) return pose;
    const part = (local - this.easing.since) / EASE;
    if (part < 1) return this.mix(this.easing.from, pose, MathUtils.smoothstep(part, 0, 1));
    this.easing = undefined;
    return pose;
  }
}
