/** Triangles at rest, what is left of their areas when they move, and the little algebra that it takes. */

/** A mixed face without expression: its places (m, 3), its triangles' normals (t, 3), twice the areas long, and their squared lengths (t,). */
export interface Rested {
  readonly points: Float64Array;
  readonly normals: Float64Array;
  readonly sizes: Float64Array;
}

/** Triangles (four numbers each, of which three are places) of places (m, 3) at rest. */
export function restTriangles(points: Float64Array, triangles: Uint32Array): Rested {
  const count = triangles.length / 4;
  const [normals, sizes] = [new Float64Array(3 * count), new Float64Array(count)];
  for (let t = 0; t < count; t++) {
    const [i, j, k] = cornersOf(triangles, t);
    const normal = cross(between(points, points, i, j), between(points, points, i, k));
    normals.set(normal, 3 * t);
    sizes[t] = dot(normal, normal);
  }
  return { points, normals, sizes };
}

/** The places of a triangle. */
export const cornersOf = (triangles: Uint32Array, t: number): [number, number, number] => [
  triangles[4 * t] as number,
  triangles[4 * t + 1] as number,
  triangles[4 * t + 2] as number,
];

/** From a point of some to a point of others. */
export const between = (
  one: Float64Array | Float32Array,
  other: Float64Array,
  from: number,
  to: number,
): [number, number, number] => [
  (other[3 * to] as number) - (one[3 * from] as number),
  (other[3 * to + 1] as number) - (one[3 * from + 1] as number),
  (other[3 * to + 2] as number) - (one[3 * from + 2] as number),
];

export const dot = (a: readonly number[], b: readonly number[]): number =>
  (a[0] as number) * (b[0] as number) + (a[1] as number) * (b[1] as number) + (a[2] as number) * (b[2] as number);

export const cross = (a: readonly number[], b: readonly number[]): number[] => [
  (a[1] as number) * (b[2] as number) - (a[2] as number) * (b[1] as number),
  (a[2] as number) * (b[0] as number) - (a[0] as number) * (b[2] as number),
  (a[0] as number) * (b[1] as number) - (a[1] as number) * (b[0] as number),
];

/** What is left of a triangle's area, seen along its normal at rest; in plain numbers, for every triangle is asked. */
export function areaLeft(points: Float64Array, triangles: Uint32Array, rest: Rested, t: number): number {
  const i = 3 * (triangles[4 * t] as number);
  const j = 3 * (triangles[4 * t + 1] as number);
  const k = 3 * (triangles[4 * t + 2] as number);
  const bx = (points[j] as number) - (points[i] as number);
  const by = (points[j + 1] as number) - (points[i + 1] as number);
  const bz = (points[j + 2] as number) - (points[i + 2] as number);
  const cx = (points[k] as number) - (points[i] as number);
  const cy = (points[k + 1] as number) - (points[i + 1] as number);
  const cz = (points[k + 2] as number) - (points[i + 2] as number);
  const along =
    (by * cz - bz * cy) * (rest.normals[3 * t] as number) +
    (bz * cx - bx * cz) * (rest.normals[3 * t + 1] as number) +
    (bx * cy - by * cx) * (rest.normals[3 * t + 2] as number);
  return along / (rest.sizes[t] as number);
}
