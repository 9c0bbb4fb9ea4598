/** The palm: a frame in which the fingers' places say what the fingers do, whichever way the hand is turned. */

import { type FoundHand, HAND_POINTS } from "./hand_messages";

/** Three axes in one row of nine: the palm's width (from the little finger to the index), the fingers' direction, the palm's normal. */
export type Axes = readonly number[];

/** A hand's palm: its axes, its wrist, and its length from the wrist to the middle knuckle. */
export interface Palm {
  axes: Axes;
  wrist: readonly [number, number, number];
  length: number;
}

const [WRIST, INDEX, MIDDLE, LITTLE] = [0, 5, 9, 17];
/** Numbers of a hand's shape: x, y, z of each point, of both sets. */
export const SHAPE_SIZE = 2 * 3 * HAND_POINTS;

type Points = ArrayLike<number>;
type Triple = [number, number, number];

const at = (points: Points, row: number): Triple => [
  points[3 * row] ?? 0,
  points[3 * row + 1] ?? 0,
  points[3 * row + 2] ?? 0,
];
const minus = (a: Triple, b: Triple): Triple => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Triple, b: Triple): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const times = (a: Triple, factor: number): Triple => [a[0] * factor, a[1] * factor, a[2] * factor];
const cross = (a: Triple, b: Triple): Triple => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** The palm of a hand; null where its points give none. points: of equal scale along all axes. */
export function palmOf(points: Points): Palm | null {
  const wrist = at(points, WRIST);
  const reach = minus(at(points, MIDDLE), wrist);
  const length = Math.sqrt(dot(reach, reach));
  if (!(length > 1e-6)) return null;
  const along = times(reach, 1 / length);
  const knuckles = minus(at(points, INDEX), at(points, LITTLE));
  const sideways = minus(knuckles, times(along, dot(knuckles, along)));
  const width = Math.sqrt(dot(sideways, sideways));
  if (!(width > 1e-6)) return null;
  const across = times(sideways, 1 / width);
  return { axes: [...across, ...along, ...cross(across, along)], wrist, length };
}

/** The points of a picture with one scale along all axes: widths of the picture. */
export function squarePoints(image: Points, width: number, height: number): Float64Array {
  const square = Float64Array.from(image);
  for (let row = 0; row < square.length / 3; row++) square[3 * row + 1] = (square[3 * row + 1] ?? 0) * (height / width);
  return square;
}

/** Where all points lie in the palm's frame, in lengths of the palm: of the picture, then of the model's own space; null without a palm. */
export function handShape(hand: FoundHand, width: number, height: number): Float64Array | null {
  const shape = new Float64Array(SHAPE_SIZE);
  const sets = [squarePoints(hand.image, width, height), hand.world];
  for (const [set, points] of sets.entries()) {
    const palm = palmOf(points);
    if (palm === null) return null;
    for (let row = 0; row < HAND_POINTS; row++) {
      const seen = minus(at(points, row), [...palm.wrist]);
      for (let axis = 0; axis < 3; axis++) {
        const [x = 0, y = 0, z = 0] = palm.axes.slice(3 * axis, 3 * axis + 3);
        shape[3 * (HAND_POINTS * set + row) + axis] = (seen[0] * x + seen[1] * y + seen[2] * z) / palm.length;
      }
    }
  }
  return shape;
}

/** How the palm has turned since it rested, about its own axes at rest: its normal (yaw), its width (pitch), its fingers' direction (roll); radians. */
export function palmTurn(now: Axes, rest: Axes): Triple {
  const entry = (row: number, column: number): number => {
    let sum = 0;
    for (let axis = 0; axis < 3; axis++) sum += (rest[3 * row + axis] ?? 0) * (now[3 * column + axis] ?? 0);
    return sum;
  };
  // The turn is yaw about z, then pitch about x, then roll about y, from the outside: Rz Rx Ry.
  const pitch = Math.asin(Math.min(1, Math.max(-1, entry(2, 1))));
  return [Math.atan2(-entry(0, 1), entry(1, 1)), pitch, Math.atan2(-entry(2, 0), entry(2, 2))];
}

/** The angle between the widths of two palms, radians: how far a hand has turned to the lens, or from it. */
export function widthAngle(now: Axes, rest: Axes): number {
  let sum = 0;
  for (let axis = 0; axis < 3; axis++) sum += (now[axis] ?? 0) * (rest[axis] ?? 0);
  return Math.acos(Math.min(1, Math.max(-1, sum)));
}
