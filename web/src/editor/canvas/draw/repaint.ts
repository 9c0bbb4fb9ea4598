/** Which part of a face's picture must be drawn anew when a hand moves some of its rows: pixels are what drawing costs. */

import type { Box, Camera } from "../math/camera";
import { ahead, cut, holds } from "../math/triangle_cut";
import type { Triple } from "../math/vectors";
import type { Figure } from "../model/figure";
import type { Member } from "./expression_scene";
import type { Indices, Painter } from "./face_painter";

/** The triangles of a part of a face's picture, and how far they serve. */
interface Cut {
  cover: Box;
  reach: number;
  indices: Indices;
}

/** A part of a tile, and the triangles that show in it. */
export interface Changed {
  part: Box;
  only?: (() => Indices) | undefined;
}

/** A face in its tile, and what of it is drawn. */
export interface Tile extends Changed {
  n: number;
  member: Member;
  camera: Camera;
  ground: readonly [number, number, number];
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
