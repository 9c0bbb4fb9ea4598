/** Idle motion of the head while the server is away. */

import type { Pose } from "./pose";

const RISE = 2.0; // seconds until the breath is full, and until it is gone again
const CYCLE = 4.6; // seconds a breath takes
const PITCH = 0.011; // radians the head nods with it
const SWAY = 0.006; // radians it tilts, slower

/** Keeps a held face alive: while the server is away the head moves with a calm breath. */
export class Breath {
  private depth = 0;
  private clock = 0;

  /** The pose with its breath, `seconds` after the last call; `alone`: no server. */
  on(pose: Pose, alone: boolean, seconds: number): Pose {
    this.depth = Math.min(1, Math.max(0, this.depth + (alone ? seconds : -seconds) / RISE));
    this.clock = this.depth === 0 ? 0 : this.clock + seconds;
    if (this.depth === 0) return pose;
    const turn = (2 * Math.PI * this.clock) / CYCLE;
    const [yaw, pitch, roll] = pose.head;
    return {
      ...pose,
      head: [yaw, pitch + this.depth * PITCH * Math.sin(turn), roll + this.depth * SWAY * Math.sin(turn * 0.37)],
    };
  }
}
