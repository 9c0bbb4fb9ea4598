/** Points and directions in space as plain tuples, which are never changed in place; matrices are three's (`camera.ts`). */

export type Triple = [number, number, number];
export type Pair = [number, number];

export const add = (a: Readonly<Triple>, b: Readonly<Triple>): Triple => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const minus = (a: Readonly<Triple>, b: Readonly<Triple>): Triple => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (a: Readonly<Triple>, by: number): Triple => [a[0] * by, a[1] * by, a[2] * by];
export const dot = (a: Readonly<Triple>, b: Readonly<Triple>): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Readonly<Triple>, b: Readonly<Triple>): Triple => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const size = (a: Readonly<Triple>): number => Math.hypot(a[0], a[1], a[2]);
export const unit = (a: Readonly<Triple>): Triple => times(a, 1 / Math.max(size(a), 1e-12));

/** Row `row` of points (n, 3). */
export const rowOf = (points: ArrayLike<number>, row: number): Triple => [
  points[3 * row] as number,
  points[3 * row + 1] as number,
  points[3 * row + 2] as number,
];

/** The solution x of x[0] a + x[1] b + x[2] c = goal; undefined where a, b and c lie (nearly) in one plane. */
export function solved(
  a: Readonly<Triple>,
  b: Readonly<Triple>,
  c: Readonly<Triple>,
  goal: Readonly<Triple>,
): Triple | undefined {
  const volume = dot(a, cross(b, c));
  if (Math.abs(volume) <= 1e-6 * size(a) * size(b) * size(c)) return undefined;
  return [dot(goal, cross(b, c)) / volume, dot(a, cross(goal, c)) / volume, dot(a, cross(b, goal)) / volume];
}
