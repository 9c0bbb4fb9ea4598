/** Topology of meshes by rows of the positions: fans, borders, distances along the skin, extents. */

import type { Mesh } from "../../link/assets";

/** For every row of the positions the triangles around it: pairs of the other two rows, from `starts[row]` on. */
export interface Fans {
  starts: Uint32Array; // rows + 1
  pairs: Uint32Array; // 2 per triangle corner, in winding order
}

/** For each row the first and the end slot of its fan, two numbers a row: how the GPU reads it. */
export function fanSpans({ starts }: Fans): Uint32Array {
  const spans = new Uint32Array(2 * (starts.length - 1));
  for (let row = 0; row + 1 < starts.length; row++)
    spans.set([starts[row] as number, starts[row + 1] as number], 2 * row);
  return spans;
}

/** Triangles as rows of the positions. */
export const rowTriangles = (mesh: Mesh): Uint32Array => mesh.triangles.map((corner) => mesh.source[corner] as number);

/** The fans of all rows under these triangles. */
export function fans(triangles: readonly Uint32Array[], rows: number): Fans {
  const starts = new Uint32Array(rows + 1);
  for (const list of triangles) for (const row of list) starts[row + 1] = (starts[row + 1] as number) + 1;
  for (let row = 0; row < rows; row++) starts[row + 1] = (starts[row + 1] as number) + (starts[row] as number);
  const filled = starts.slice(0, rows);
  const pairs = new Uint32Array(2 * (starts[rows] as number));
  for (const list of triangles)
    for (let corner = 0; corner < list.length; corner++) {
      const first = corner - (corner % 3);
      const row = list[corner] as number;
      const slot = filled[row] as number;
      filled[row] = slot + 1;
      pairs[2 * slot] = list[first + ((corner + 1) % 3)] as number;
      pairs[2 * slot + 1] = list[first + ((corner + 2) % 3)] as number;
    }
  return { starts, pairs };
}

/** Visits the neighbours of a row (each as often as triangles share the edge). */
export function neighbours(of: Fans, row: number, visit: (other: number) => void): void {
  for (let slot = 2 * (of.starts[row] as number); slot < 2 * (of.starts[row + 1] as number); slot++)
    visit(of.pairs[slot] as number);
}

/** The border loop that holds the lowest point, in walking order; empty when the mesh is closed there. */
export function lowestBorder(triangles: Uint32Array, positions: Float32Array): number[] {
  const next = borderEdges(triangles);
  let start: number | undefined;
  for (const row of next.keys())
    if (start === undefined || height(positions, row) < height(positions, start)) start = row;
  const loop: number[] = [];
  for (let row = start; row !== undefined && loop.length <= next.size; row = next.get(row)) {
    if (row === start && loop.length > 0) return loop;
    loop.push(row);
  }
  return [];
}

const height = (positions: Float32Array, row: number): number => positions[3 * row + 1] as number;

function borderEdges(triangles: Uint32Array): Map<number, number> {
  const edges = new Map<string, [number, number]>();
  for (let corner = 0; corner < triangles.length; corner++) {
    const from = triangles[corner] as number;
    const to = triangles[corner - (corner % 3) + ((corner + 1) % 3)] as number;
    if (!edges.delete(`${to},${from}`)) edges.set(`${from},${to}`, [from, to]);
  }
  return new Map(edges.values());
}

/** Metres along the edges from the nearest of `sources`; Infinity where no edge leads. */
export function distances(of: Fans, positions: Float32Array, sources: readonly number[]): Float32Array {
  const far = new Float32Array(of.starts.length - 1).fill(Infinity);
  let front = [...sources];
  for (const row of front) far[row] = 0;
  while (front.length > 0) {
    const reached = new Set<number>();
    for (const row of front)
      neighbours(of, row, (other) => {
        const there = (far[row] as number) + edgeLength(positions, row, other);
        if (there < (far[other] as number) - 1e-9) {
          far[other] = there;
          reached.add(other);
        }
      });
    front = [...reached];
  }
  return far;
}

function edgeLength(positions: Float32Array, a: number, b: number): number {
  const [i, j] = [3 * a, 3 * b];
  const x = (positions[i] as number) - (positions[j] as number);
  const y = (positions[i + 1] as number) - (positions[j + 1] as number);
  const z = (positions[i + 2] as number) - (positions[j + 2] as number);
  return Math.hypot(x, y, z);
}

/** Values averaged over the one-ring `rounds` times; `width` numbers per row. */
export function smoothed(of: Fans, values: Float32Array, width: number, rounds: number): Float32Array {
  let [from, to] = [values.slice(), values.slice()];
  for (let round = 0; round < rounds; round++) {
    for (let row = 0; row < of.starts.length - 1; row++) averageRing(of, from, to, row, width);
    [from, to] = [to, from];
  }
  return from;
}

function averageRing(of: Fans, from: Float32Array, to: Float32Array, row: number, width: number): void {
  let count = 0;
  for (let part = 0; part < width; part++) to[width * row + part] = 0;
  neighbours(of, row, (other) => {
    count += 1;
    for (let part = 0; part < width; part++)
      to[width * row + part] = (to[width * row + part] as number) + (from[width * other + part] as number);
  });
  for (let part = 0; part < width; part++) {
    const at = width * row + part;
    to[at] = count === 0 ? (from[at] as number) : (to[at] as number) / count;
  }
}

/** The least and greatest coordinate of some rows on an axis. */
export function extent(positions: Float32Array, axis: number, rows: Uint32Array): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const row of rows) {
    const value = positions[3 * row + axis] as number;
    [low, high] = [Math.min(low, value), Math.max(high, value)];
  }
  return [low, high];
}

/** The area-weighted unit normal of a row from the triangles around it; positions: `width` numbers a row. */
export function normalAt(
  { starts, pairs }: Fans,
  positions: Float32Array,
  row: number,
  width = 3,
): [number, number, number] {
  const at = (place: number, axis: number): number => positions[width * place + axis] as number;
  const [x, y, z] = [at(row, 0), at(row, 1), at(row, 2)];
  const sum: [number, number, number] = [0, 0, 0];
  for (let slot = starts[row] as number; slot < (starts[row + 1] as number); slot++) {
    const a = pairs[2 * slot] as number;
    const b = pairs[2 * slot + 1] as number;
    const ax = at(a, 0) - x;
    const ay = at(a, 1) - y;
    const az = at(a, 2) - z;
    const bx = at(b, 0) - x;
    const by = at(b, 1) - y;
    const bz = at(b, 2) - z;
    sum[0] += ay * bz - az * by;
    sum[1] += az * bx - ax * bz;
    sum[2] += ax * by - ay * bx;
  }
  const size = Math.sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  return size > 0 ? [sum[0] / size, sum[1] / size, sum[2] / size] : [0, 0, 1];
}
