/** Idle motion of the head while the server is away. */

import type { ScenePose } from "./scene_pose";

const RISE = 2.0; // seconds until the breath is full, and until it is gone again
const CYCLE = 4.6; // seconds a breath takes
const PITCH = 0.011; // radians the head nods with it
const SWAY = 0.006; // radians it tilts, slower
const APART = 0.39; // cycles from one character to the next, so that they do not nod together

/** Keeps held faces alive: while the server is away their heads move with a calm breath. */
export class Breath {
  private depth = 0;
  private clock = 0;

  /** The scene with its breath, `seconds` after the last call; `alone`: no server. */
  on(scene: ScenePose, alone: boolean, seconds: number): ScenePose {
    this.depth = Math.min(1, Math.max(0, this.depth + (alone ? seconds : -seconds) / RISE));
    this.clock = this.depth === 0 ? 0 : this.clock + seconds;
    if (this.depth === 0) return scene;
    const breathing = Object.entries(scene.characters).map(([name, pose], place) => {
      const [yaw, pitch, roll] = pose.head;
      const [nod, tilt] = this.turns(place * APART);
      return [name, { ...pose, head: [yaw, pitch + nod, roll + tilt] as typeof pose.head }] as const;
    });
    return { ...scene, characters: Object.fromEntries(breathing) };
  }

  /** Radians of nod and tilt of one who breathes so many cycles ahead. */
  private turns(ahead: number): [number, number] {
    const turn = 2 * Math.PI * (this.clock / CYCLE + ahead);
    return [this.depth * PITCH * Math.sin(turn), this.depth * SWAY * Math.sin(turn * 0.37)];
  }
}
