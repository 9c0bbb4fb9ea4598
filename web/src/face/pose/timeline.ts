/** Interpolates the poses that arrive to the time that is drawn. */

import { MathUtils } from "three";
import { mixPoses, type Pose } from "./pose";

/** A pose and when it is due, in server seconds. */
export interface Timed extends Pose {
  time: number;
  epoch: number;
}

const GAP = 0.25; // seconds without a state after which the next one is eased to
const EASE = 0.4; // seconds the easing takes
const KEPT = 64;

/** The states of the last second, to be drawn a little late so that there is one on either side of every frame. */
export class Timeline {
  private states: Timed[] = [];
  private arrived = -Infinity;
  private shown: Pose | undefined;
  private easing: { from: Pose; since: number } | undefined;

  /** A state that arrived at `local` (our seconds), newer than all before. */
  push(state: Timed, local: number): void {
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

  /** The pose for server time `due` at our time `local`: between states a mix, past the newest the newest (held). */
  at(due: number, local: number): Pose | undefined {
    const pose = this.sample(due);
    if (pose !== undefined) this.shown = this.eased(pose, local);
    return this.shown;
  }

  private sample(due: number): Pose | undefined {
    const after = this.states.findIndex((state) => state.time > due);
    if (after < 0) return this.states.at(-1);
    const next = this.states[after] as Timed;
    const before = this.states[after - 1];
    if (before === undefined) return next;
    return mixPoses(before, next, (due - before.time) / (next.time - before.time));
  }

  private eased(pose: Pose, local: number): Pose {
    if (this.easing === undefined) return pose;
    const part = (local - this.easing.since) / EASE;
    if (part < 1) return mixPoses(this.easing.from, pose, MathUtils.smoothstep(part, 0, 1));
    this.easing = undefined;
    return pose;
  }
}
