/** Hair that lags behind a head that turns, and swings after it. */

import { Vector3 } from "three";

/** A damped spring: Hz, the damping ratio, and radians at most that hair lags. */
const [FREQUENCY, DAMPING, FARTHEST] = [2.2, 0.42, 0.2];
/** Radians, and radians a second, below which nobody sees it move. */
const [RESTING, SLOW] = [0.0005, 0.004];

const [STIFFNESS, FRICTION] = [(2 * Math.PI * FREQUENCY) ** 2, 4 * Math.PI * FREQUENCY * DAMPING];

/** How far the hair of one character is turned against its head. */
export class HairSwing {
  /** A rotation vector in the head's own axes, radians. */
  readonly offset = new Vector3();
  private readonly head = new Vector3();
  private readonly speed = new Vector3();
  private placed = false;

  /** The head turned to yaw, pitch and roll (radians, as a pose has them) within `seconds`; `atOnce`: it was there before. */
  follow([yaw, pitch, roll]: readonly [number, number, number], seconds: number, atOnce: boolean): void {
    const { offset, head, speed } = this;
    const turn = new Vector3(-pitch, yaw, -roll);
    if (atOnce || !this.placed) {
      offset.setScalar(0);
      speed.setScalar(0);
    } else {
      offset.add(head).sub(turn); // the hair is where it was
      // An implicit step (Baraff and Witkin 1998): it dies away over frames of any length
      const slowed = 1 + seconds * FRICTION + seconds * seconds * STIFFNESS;
      speed.addScaledVector(offset, -seconds * STIFFNESS).divideScalar(slowed);
      offset.addScaledVector(speed, seconds).clampLength(0, FARTHEST);
    }
    head.copy(turn);
    this.placed = true;
    if (!this.still) return;
    offset.setScalar(0);
    speed.setScalar(0);
  }

  /** Whether it hangs at rest. */
  get still(): boolean {
    return this.offset.length() < RESTING && this.speed.length() < SLOW;
  }
}
