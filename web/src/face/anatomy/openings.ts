/** The openings of the skin (lids, lips) as two edges from corner to corner. */

/** The edges of an opening of the skin, from the character's right corner to its left one: rows of the positions. */
export interface Opening {
  upper: number[];
  lower: number[];
}

/** Points that each edge is followed by in the shaders (`opening_shaders.ts`). */
export const EDGE_POINTS = 12;

/** The edges that a closed line of rows has between its outermost points; positions: (rows, 3) of the generic face. */
export function opening(loop: readonly number[], positions: Float32Array, points = EDGE_POINTS): Opening {
  const across = loop.map((row) => positions[3 * row] as number);
  const right = across.indexOf(Math.min(...across));
  const left = across.indexOf(Math.max(...across));
  const path = thinned(walk(loop, right, left), points);
  const other = thinned(walk([...loop].reverse(), loop.length - 1 - right, loop.length - 1 - left), points);
  return meanHeight(path, positions) > meanHeight(other, positions)
    ? { upper: path, lower: other }
    : { upper: other, lower: path };
}

/** The outermost of some rows, right, top, left, bottom: a line for what has none of its own. */
export function outline(rows: readonly number[], positions: Float32Array): number[] {
  const farthest = (axis: number, sign: number) =>
    rows.reduce((best, row) =>
      sign * ((positions[3 * row + axis] as number) - (positions[3 * best + axis] as number)) > 0 ? row : best,
    );
  return [farthest(0, -1), farthest(1, 1), farthest(0, 1), farthest(1, -1)];
}

/** The rows of a closed line from one place to another, both included. */
function walk(loop: readonly number[], from: number, to: number): number[] {
  const steps = (to - from + loop.length) % loop.length;
  return Array.from({ length: steps + 1 }, (_, step) => loop[(from + step) % loop.length] as number);
}

/** As many rows as asked for, evenly chosen, the ends kept; rows repeat where there are fewer. */
function thinned(rows: readonly number[], points: number): number[] {
  return Array.from({ length: points }, (_, n) => rows[Math.round((n * (rows.length - 1)) / (points - 1))] as number);
}

const meanHeight = (rows: readonly number[], positions: Float32Array): number =>
  rows.reduce((sum, row) => sum + (positions[3 * row + 1] as number), 0) / rows.length;
