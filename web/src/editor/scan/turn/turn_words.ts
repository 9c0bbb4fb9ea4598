/** What a person before the camera is told to do. */

import { type DirectionName, directionAt, nextWanted } from "./turn_directions";

/** Degrees: who is so near to what is wanted is told which way it is. */
const NEAR = 12;

/** For a moment, while a picture is taken. */
export const HOLD = "Hold still …";

/** What to do while these are wanted, by how the head is turned now, degrees to its own left. */
export function guideTo(wanted: ReadonlySet<DirectionName>, yaw: number): string {
  const [here, next] = [directionAt(yaw), nextWanted(wanted)];
  if (here !== null && wanted.has(here.name)) return HOLD;
  if (next === null) return "All are taken.";
  if (next.name === "front") return "Look straight into the camera.";
  const off = next.yaw - yaw;
  const way = Math.abs(off) > next.reach + NEAR ? "Turn your head slowly" : "A little further";
  return `${way} to your ${off > 0 ? "left" : "right"}.`;
}
