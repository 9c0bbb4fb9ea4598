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

/** Where rows of a face are, led by a hand, and whence. */
export function spreadOf({ base, live }: Pick<Figure, "base" | "live">, rows: Uint32Array): Spread {
  const low: Triple = [Infinity, Infinity, Infinity];
  const high: Triple = [-Infinity, -Infinity, -Infinity];
  let most = 0;
  for (const row of rows) {
    let sum = 0;
    for (const axis of [0, 1, 2] as const) {
      const [from, to] = [base[3 * row + axis] as number, live[3 * row + axis] as number];
      sum += (to - from) ** 2;
      low[axis] = Math.min(low[axis], from, to);
      high[axis] = Math.max(high[axis], from, to);
    }
    most = Math.max(most, sum);
  }
  return { low, high, reach: Math.sqrt(most) };
}

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
