/** The directions in which a head is wanted, from the person's own left to their right, as a mirror shows them. */

export type DirectionName = "left" | "half left" | "front" | "half right" | "right";

export interface Direction {
  readonly name: DirectionName;
  /** Yaw in degrees, + to the person's own left: what is best, and how far from it is taken too. */
  readonly yaw: number;
  readonly reach: number;
}

export const DIRECTIONS: readonly Direction[] = [
  { name: "left", yaw: 40, reach: 9 },
  { name: "half left", yaw: 21, reach: 7 },
  { name: "front", yaw: 0, reach: 8 },
  { name: "half right", yaw: -21, reach: 7 },
  { name: "right", yaw: -40, reach: 9 },
];

/** The order in which they are asked for: once to the left, and over to the right. */
const ORDER: readonly DirectionName[] = ["front", "half left", "left", "half right", "right"];

/** The direction that a yaw belongs to; null: it lies between two, or beyond. */
export const directionAt = (yaw: number): Direction | null =>
  DIRECTIONS.find((direction) => Math.abs(yaw - direction.yaw) <= direction.reach) ?? null;

/** What is asked for next; null where nothing is wanted any more. */
export function nextWanted(wanted: ReadonlySet<DirectionName>): Direction | null {
  const name = ORDER.find((candidate) => wanted.has(candidate));
  return DIRECTIONS.find((direction) => direction.name === name) ?? null;
}
