/** Which part of a face's picture must be drawn anew when a hand moves some of its rows: pixels are what drawing costs. */

import type { Box, Camera } from "./camera";
import { ahead, cut, holds } from "./cut";
import type { Figure } from "./figure";
import type { Indices, Painter } from "./painter";
import type { Triple } from "./triples";

/** The triangles of a part of a face's picture, and how far they serve. */
interface Cut {
  cover: Box;
  reach: number;
  indices: Indices;
}

const NOWHERE: Box = { left: 0, top: 0, width: -1, height: -1 };
const EDGE = 2; // CSS pixels for what lies on a pixel's border

/** The least box that holds both. */
function around(a: Box, b: Box): Box {
  const [left, top] = [Math.min(a.left, b.left), Math.min(a.top, b.top)];
  const right = Math.max(a.left + a.width, b.left + b.width);
  return { left, top, width: right - left, height: Math.max(a.top + a.height, b.top + b.height) - top };
}

/** What of a box lies in another; empty: no width, no height. */
export function within(box: Box, tile: Box): Box {
  const [left, top] = [Math.max(box.left, tile.left), Math.max(box.top, tile.top)];
  const right = Math.min(box.left + box.width, tile.left + tile.width);
  const bottom = Math.min(box.top + box.height, tile.top + tile.height);
  return { left, top, width: Math.max(0, right - left), height: Math.max(0, bottom - top) };
}

/** How far a field (V, 4) leads a face's rows at most, metres. */
export function farthestOf({ tangents }: Figure, rows: Uint32Array, field: Float32Array | undefined): number {
  if (field === undefined || tangents === undefined) return 0;
  const size = tangents.length / 3;
  let most = 0;
  for (const row of rows) {
    if (3 * row >= size) continue;
    let sum = 0;
    for (let at = 3 * row; at < 3 * row + 3; at++) {
      const way =
        (tangents[at] as number) * (field[4 * row] as number) +
        (tangents[size + at] as number) * (field[4 * row + 1] as number) +
        (tangents[2 * size + at] as number) * (field[4 * row + 2] as number);
      sum += way * way;
    }
    most = Math.max(most, sum);
  }
  return Math.sqrt(most);
}

/** The box of the canvas, CSS pixels, that holds rows of positions (n, 3) and `reach` metres around each. */
export function boxOf(camera: Camera, positions: Float32Array, rows: Uint32Array, reach: number): Box {
  const [low, high]: [Triple, Triple] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ];
  for (const row of rows)
    for (let axis = 0; axis < 3; axis++) {
      const value = positions[3 * row + axis] as number;
      if (value - reach < (low[axis] as number)) low[axis] = value - reach;
      if (value + reach > (high[axis] as number)) high[axis] = value + reach;
    }
  const corners = Array.from({ length: 8 }, (_, n) =>
    camera.project([0, 1, 2].map((axis) => ((n >> axis) & 1 ? high : low)[axis]) as Triple),
  );
  const [across, down] = [0, 1].map((axis) => corners.map((corner) => corner[axis] as number)) as [number[], number[]];
  const [left, top] = [Math.min(...across) - EDGE, Math.min(...down) - EDGE];
  return { left, top, width: Math.max(...across) + EDGE - left, height: Math.max(...down) + EDGE - top };
}

/** Remembers for each face what was drawn anew the time before, for what moved has to go from there too; and the triangles
 * that were cut for it. */
export class Repaint {
  private readonly before = new Map<number, Box>();
  private readonly cuts = new Map<number, Cut>();

  constructor(private readonly painter: Pick<Painter, "surface" | "list">) {}

  /** All faces are drawn whole. */
  forget(): void {
    this.before.clear();
    for (const each of this.cuts.values()) each.cover = NOWHERE;
  }

  /** The triangles of face `n` that show in a part of its tile; no row goes further than `reach` from positions (n, 3). */
  triangles(n: number, part: Box, camera: Camera, positions: Float32Array, reach: number): Indices {
    const known = this.cuts.get(n);
    if (known !== undefined && holds(known.cover, part) && reach <= known.reach) return known.indices;
    const [cover, room] = [ahead(part), 2 * reach];
    const kept = cut(this.painter.surface(camera), camera, positions, cover, room);
    const indices = this.painter.list(kept, known?.indices);
    this.cuts.set(n, { cover, reach: room, indices });
    return indices;
  }

  /** What of face `n`'s tile is to be drawn when `box` of it changes. */
  next(n: number, box: Box, tile: Box): Box {
    const before = this.before.get(n);
    this.before.set(n, box);
    return within(before === undefined ? box : around(before, box), tile);
  }
}
