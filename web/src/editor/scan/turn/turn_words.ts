/** What a person before the camera is told to do. */

import type { Direction, DirectionName } from "./turn_directions";

const SIDES: Readonly<Record<DirectionName, string>> = {
  left: "Turn your head slowly to your left.",
  "half left": "Turn your head a little to your left.",
  front: "Look straight into the camera.",
  "half right": "Turn your head a little to your right.",
  right: "Turn your head slowly to your right.",
};
const FURTHER = { left: "A little further to your left.", right: "A little further to your right." };

/** Degrees: who is so near to what is wanted is told which way it is. */
const NEAR = 14;

/** What to do for what is wanted next, by how the head is turned now, degrees to its own left. */
export function guideTo(wanted: Direction | null, yaw: number): string {
  if (wanted === null) return "All are taken.";
  const off = wanted.yaw - yaw;
  if (Math.abs(off) <= wanted.reach) return "Hold still …";
  if (wanted.name === "front" || Math.abs(off) > wanted.reach + NEAR) return SIDES[wanted.name];
  return off > 0 ? FURTHER.left : FURTHER.right;
}
