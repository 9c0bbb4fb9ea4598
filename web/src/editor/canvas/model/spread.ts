/** Where the rows of a face are that a hand has moved: what of its picture must be drawn anew. */

import type { Box } from "../math/boxes";
import type { Camera } from "../math/camera";
import type { Triple } from "../math/vectors";
import type { Figure } from "./figure";

/** Where rows of a face may be, metres: the least and the greatest x, y and z, and how far the farthest has gone. */
export interface Spread {
  low: Triple;
  high: Triple;
  reach: number;
}

/** Where a field (V, 4) leads rows of a face from its base, and whence. */
export function spreadOf(
  { tangents, base }: Pick<Figure, "tangents" | "base">,
  rows: Uint32Array,
  field: Float32Array | undefined,
): Spread {
  const low: Triple = [Infinity, Infinity, Infinity];
  const high: Triple = [-Infinity, -Infinity, -Infinity];
  const size = tangents === undefined || field === undefined ? 0 : tangents.length / 3;
  let most = 0;
  for (const row of rows) {
    const at = 3 * row;
    const led = at < size;
    let sum = 0;
    for (let axis = 0; axis < 3; axis++) {
      const value = base[at + axis] as number;
      const way = led ? wayOf(tangents as Float32Array, field as Float32Array, size, row, axis) : 0;
      sum += way * way;
      low[axis] = Math.min(low[axis] as number, value, value + way);
      high[axis] = Math.max(high[axis] as number, value, value + way);
    }
    most = Math.max(most, sum);
  }
  return { low, high, reach: Math.sqrt(most) };
}

const wayOf = (tangents: Float32Array, field: Float32Array, size: number, row: number, axis: number): number =>
  (tangents[3 * row + axis] as number) * (field[4 * row] as number) +
  (tangents[size + 3 * row + axis] as number) * (field[4 * row + 1] as number) +
  (tangents[2 * size + 3 * row + axis] as number) * (field[4 * row + 2] as number);

/** The box of the canvas, CSS pixels, that holds a spread and `border` metres around it. */
export function boxOf(camera: Camera, { low, high }: Spread, border: number): Box {
  const corners = Array.from({ length: 8 }, (_, n) =>
    camera.project(
      [0, 1, 2].map((axis) =>
        (n >> axis) & 1 ? (high[axis] as number) + border : (low[axis] as number) - border,
      ) as Triple,
    ),
  );
  const [across, down] = [0, 1].map((axis) => corners.map((corner) => corner[axis] as number)) as [number[], number[]];
  const [left, top] = [Math.min(...across) - EDGE, Math.min(...down) - EDGE];
  return { left, top, width: Math.max(...across) + EDGE - left, height: Math.max(...down) + EDGE - top };
}

const EDGE = 2; // CSS pixels for what lies on a pixel's border
