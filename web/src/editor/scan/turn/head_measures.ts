/** How a head is turned and what its face does, from the landmarks of one picture. */

import type { Landmarks } from "../../../face_mesh/landmark_messages";

/** Angles in degrees: + is to the person's own left, up, tilt to their left. */
export interface HeadMeasures {
  readonly yaw: number;
  readonly pitch: number;
  readonly roll: number;
  /** How high the gap of the lips is, of the height of the face. */
  readonly mouth: number;
  /** How high the gap of the lids is, of the width of the eye; of two that are seen as well, the less open one. */
  readonly lids: number;
  /** The height of the face, pixels. */
  readonly height: number;
}

type Vector = readonly [number, number, number];

/** Rows of the face mesh: pairs of points that lie side by side on a head, right and left. */
const ACROSS = [
  [234, 454],
  [127, 356],
  [33, 263],
] as const;
const [FOREHEAD, CHIN] = [10, 152];
const LIPS = [13, 14] as const;
/** Outer and inner corner, upper and lower lid. */
const RIGHT_EYE = [33, 133, 159, 145] as const;
const LEFT_EYE = [263, 362, 386, 374] as const;
/** Degrees of yaw from which on the farther eye is not measured. */
const FAR = 12;
/** Degrees by which the chin lies behind the forehead on a head that looks straight ahead. */
const AT_REST = 6;
const DEGREES = 180 / Math.PI;

/** The measures of a picture with a face. */
export function measureHead({ points, width, height: tall }: Landmarks): HeadMeasures {
  const at = (row: number): Vector => [
    (points[3 * row] as number) * width,
    (points[3 * row + 1] as number) * tall,
    (points[3 * row + 2] as number) * width, // the model says depth in widths
  ];
  const [x, y, z] = sum(ACROSS.map(([right, left]) => from(at(right), at(left))));
  const [, down, back] = from(at(FOREHEAD), at(CHIN));
  const yaw = DEGREES * Math.atan2(z, Math.hypot(x, y));
  const height = distance(at(FOREHEAD), at(CHIN));
  const open = ([outer, inner, upper, lower]: readonly [number, number, number, number]): number =>
    distance(at(upper), at(lower)) / distance(at(outer), at(inner));
  const seen = [...(yaw < FAR ? [open(LEFT_EYE)] : []), ...(yaw > -FAR ? [open(RIGHT_EYE)] : [])];
  return {
    yaw,
    pitch: AT_REST - DEGREES * Math.atan2(back, down),
    roll: DEGREES * Math.atan2(y, x),
    mouth: distance(at(LIPS[0]), at(LIPS[1])) / height,
    lids: Math.min(...seen),
    height,
  };
}

/** How fast landmarks move from one picture to the next, heights of the face a second. */
export function speedBetween(before: Landmarks, now: Landmarks): number {
  const seconds = (now.time - before.time) / 1000;
  if (before.points.length !== now.points.length || seconds <= 0) return Number.POSITIVE_INFINITY;
  let way = 0;
  for (let place = 0; place < now.points.length; place += 3) {
    const dx = (now.points[place] as number) - (before.points[place] as number);
    const dy = (now.points[place + 1] as number) - (before.points[place + 1] as number);
    way += Math.hypot(dx * now.width, dy * now.height);
  }
  return way / (now.points.length / 3) / measureHead(now).height / seconds;
}

const from = (start: Vector, end: Vector): Vector => [end[0] - start[0], end[1] - start[1], end[2] - start[2]];

const distance = (point: Vector, other: Vector): number => Math.hypot(...from(point, other));

const sum = (vectors: readonly Vector[]): Vector =>
  vectors.reduce(([x, y, z], [dx, dy, dz]) => [x + dx, y + dy, z + dz]);
