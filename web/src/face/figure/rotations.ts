/** Rotations of bones: 3 x 3 matrices row by row, rotation vectors, quaternions. */

export type Vector = readonly [number, number, number];
/** A rotation, row by row. */
export type Rotation = readonly [number, number, number, number, number, number, number, number, number];
/** x, y, z, w. */
export type Quaternion = readonly [number, number, number, number];

export const IDENTITY: Rotation = [1, 0, 0, 0, 1, 0, 0, 0, 1];
export const ORIGIN: Vector = [0, 0, 0];

export const plus = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scaled = (a: Vector, by: number): Vector => [a[0] * by, a[1] * by, a[2] * by];
export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a: Vector): number => Math.sqrt(dot(a, a));
export const unit = (a: Vector): Vector => scaled(a, 1 / length(a));
export const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

export const turnedBy = (r: Rotation, v: Vector): Vector => [
  r[0] * v[0] + r[1] * v[1] + r[2] * v[2],
  r[3] * v[0] + r[4] * v[1] + r[5] * v[2],
  r[6] * v[0] + r[7] * v[1] + r[8] * v[2],
];

/** First b, then a. */
export const product = (a: Rotation, b: Rotation): Rotation => [
  a[0] * b[0] + a[1] * b[3] + a[2] * b[6],
  a[0] * b[1] + a[1] * b[4] + a[2] * b[7],
  a[0] * b[2] + a[1] * b[5] + a[2] * b[8],
  a[3] * b[0] + a[4] * b[3] + a[5] * b[6],
  a[3] * b[1] + a[4] * b[4] + a[5] * b[7],
  a[3] * b[2] + a[4] * b[5] + a[5] * b[8],
  a[6] * b[0] + a[7] * b[3] + a[8] * b[6],
  a[6] * b[1] + a[7] * b[4] + a[8] * b[7],
  a[6] * b[2] + a[7] * b[5] + a[8] * b[8],
];

export const inverse = (r: Rotation): Rotation => [r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]];

/** The rotation of a rotation vector, radians (O. Rodrigues, 1840). */
export function rotationOf(vector: Vector): Rotation {
  const angle = length(vector);
  if (angle < 1e-12) return IDENTITY;
  const [x, y, z] = scaled(vector, 1 / angle);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const t = 1 - c;
  return [
    c + t * x * x,
    t * x * y - s * z,
    t * x * z + s * y,
    t * x * y + s * z,
    c + t * y * y,
    t * y * z - s * x,
    t * x * z - s * y,
    t * y * z + s * x,
    c + t * z * z,
  ];
}

/** The unit quaternion of a rotation: its greatest part is above 0, as scipy has it. */
export function quaternionOf(r: Rotation): Quaternion {
  const trace = r[0] + r[4] + r[8];
  const most = Math.max(r[0], r[4], r[8], trace);
  let q: Quaternion;
  if (most === trace) q = [r[7] - r[5], r[2] - r[6], r[3] - r[1], 1 + trace];
  else if (most === r[0]) q = [1 - trace + 2 * r[0], r[3] + r[1], r[6] + r[2], r[7] - r[5]];
  else if (most === r[4]) q = [r[1] + r[3], 1 - trace + 2 * r[4], r[7] + r[5], r[2] - r[6]];
  else q = [r[2] + r[6], r[5] + r[7], 1 - trace + 2 * r[8], r[3] - r[1]];
  const by = 1 / Math.hypot(...q);
  return [q[0] * by, q[1] * by, q[2] * by, q[3] * by];
}

/** The rotation vector of a rotation by less than half a turn, radians. */
export function vectorOf(r: Rotation): Vector {
  const [x, y, z, w] = quaternionOf(r);
  const sine = Math.hypot(x, y, z);
  if (sine < 1e-12) return ORIGIN;
  const angle = 2 * Math.atan2(w < 0 ? -sine : sine, Math.abs(w));
  return scaled([x, y, z], angle / sine);
}

/** The rotation by the smallest angle that takes one direction to another. */
export function shortestTurn(before: Vector, after: Vector): Rotation {
  const axis = cross(before, after);
  const sine = length(axis);
  if (sine < 1e-9) return IDENTITY;
  return rotationOf(scaled(axis, Math.atan2(sine, dot(before, after)) / sine));
}

/** A frame: its columns are the direction along, the part of `about` that stands on it, and their product. */
export function frameOf(along: Vector, about: Vector): Rotation {
  const square = unit(minus(about, scaled(along, dot(along, about))));
  const third = cross(along, square);
  return [along[0], square[0], third[0], along[1], square[1], third[1], along[2], square[2], third[2]];
}

/** The angle of a rotation about a direction, radians: what is left when its swing is taken off. */
export function twistAbout(turn: Rotation, axis: Vector): number {
  const [a, b, c, d, e, f, g, h, i] = turn;
  const aside: Vector = [h - f, c - g, d - b];
  return Math.atan2(dot(aside, axis), a + e + i - dot(axis, turnedBy(turn, axis)));
}
