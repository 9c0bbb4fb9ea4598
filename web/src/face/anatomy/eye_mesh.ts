/** The eyeball's mesh, and its axes from rows of the positions. */

/** A part of the unit sphere around +z: what is drawn of an eyeball. */
export interface Dome {
  directions: Float32Array; // (n, 3)
  triangles: Uint32Array; // (t, 3)
}

/** Three pairs of rows that lie opposite each other on an eyeball, and what makes its three axes of their differences. */
export interface BallFrame {
  rows: number[]; // 6
  fromPairs: number[]; // 3x3, column by column
}

type Vector = [number, number, number];

/** How far the drawn eyeball reaches around from the pupil, radians: past what any gaze can show. */
const REACH = 2.0;

/** The dome in rings around +z, which lie closer where the iris is. */
export function dome(rings: number, spokes: number): Dome {
  const directions: number[] = [0, 0, 1];
  for (let ring = 1; ring <= rings; ring++)
    for (let spoke = 0; spoke < spokes; spoke++) {
      const share = ring / rings;
      const [turn, tilt] = [(2 * Math.PI * spoke) / spokes, REACH * (0.6 * share + 0.4 * share * share)];
      directions.push(Math.sin(tilt) * Math.cos(turn), Math.sin(tilt) * Math.sin(turn), Math.cos(tilt));
    }
  const at = (ring: number, spoke: number) => (ring === 0 ? 0 : 1 + (ring - 1) * spokes + (spoke % spokes));
  const triangles: number[] = [];
  for (let ring = 0; ring < rings; ring++)
    for (let spoke = 0; spoke < spokes; spoke++) {
      triangles.push(at(ring, spoke), at(ring + 1, spoke), at(ring + 1, spoke + 1));
      if (ring > 0) triangles.push(at(ring, spoke), at(ring + 1, spoke + 1), at(ring, spoke + 1));
    }
  return { directions: new Float32Array(directions), triangles: new Uint32Array(triangles) };
}

/**
 * How to read an eyeball's axes from its blended rows: the linear map that took the generic ball, a sphere, to where the
 * ball is now is half of [p0 - p1, p2 - p3, p4 - p5] times `fromPairs`. rows: first and end of the ball.
 */
export function ballFrame(positions: Float32Array, first: number, end: number): BallFrame {
  const centre: Vector = [0, 0, 0];
  for (let row = first; row < end; row++)
    for (const axis of AXES) centre[axis] += at(positions, row, axis) / (end - first);
  const off = (row: number): Vector => AXES.map((axis) => at(positions, row, axis) - centre[axis]) as Vector;
  const radius = Array.from({ length: end - first }, (_, n) => Math.hypot(...off(first + n))).reduce(
    (a, b) => a + b,
    0,
  );
  const pairs = AXES.map((axis) => {
    const row = extreme(first, end, (candidate) => off(candidate)[axis]);
    return [row, extreme(first, end, (candidate) => -dot(off(candidate), off(row)))] as const;
  });
  const columns = pairs.map(([a, b]) => {
    const [offA, offB] = [off(a), off(b)];
    return AXES.map((axis) => ((offA[axis] - offB[axis]) * (end - first)) / (2 * radius)) as Vector;
  }) as [Vector, Vector, Vector];
  return { rows: pairs.flat(), fromPairs: inverse(columns) };
}

const AXES = [0, 1, 2] as const;

const at = (positions: Float32Array, row: number, axis: number): number => positions[3 * row + axis] as number;
const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

function extreme(first: number, end: number, height: (row: number) => number): number {
  let best = first;
  for (let row = first; row < end; row++) if (height(row) > height(best)) best = row;
  return best;
}

/** The inverse of a matrix given by its columns, column by column. */
function inverse([a, b, c]: readonly [Vector, Vector, Vector]): number[] {
  const volume = dot(a, cross(b, c));
  const rows = [cross(b, c), cross(c, a), cross(a, b)];
  return AXES.flatMap((column) => rows.map((row) => row[column] / volume));
}
