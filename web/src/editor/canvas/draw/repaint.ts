/** Which part of a face's picture must be drawn anew when a hand moves some of its rows: pixels are what drawing costs. */

import { type Box, contains, expanded, overlap, union } from "../math/boxes";
import type { Camera } from "../math/camera";
import { cut } from "../math/triangle_cut";
import type { ShownFace } from "../model/shown_face";
import type { FacePainter, Indices } from "./face_painter";

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
  member: ShownFace;
  camera: Camera;
  ground: readonly [number, number, number];
}

const NOWHERE: Box = { left: 0, top: 0, width: -1, height: -1 };

/** Remembers for each face what was drawn anew the time before, for what moved has to go from there too; and the triangles
 * that were cut for it. */
export class Repaint {
  private readonly before = new Map<number, Box>();
  private readonly cuts = new Map<number, Cut>();

  constructor(private readonly painter: Pick<FacePainter, "surface" | "list">) {}

  /** All faces are drawn whole. */
  forget(): void {
    this.before.clear();
    for (const each of this.cuts.values()) each.cover = NOWHERE;
  }

  /** The triangles of face `n` that show in a part of its tile; no row goes further than `reach` from positions (n, 3). */
  triangles(n: number, part: Box, camera: Camera, positions: Float32Array, reach: number): Indices {
    const known = this.cuts.get(n);
    if (known !== undefined && contains(known.cover, part) && reach <= known.reach) return known.indices;
    const [cover, room] = [expanded(part), 2 * reach];
    const kept = cut(this.painter.surface(camera), camera, positions, cover, room);
    const indices = this.painter.list(kept, known?.indices);
    this.cuts.set(n, { cover, reach: room, indices });
    return indices;
  }

  /** What of face `n`'s tile is to be drawn when `box` of it changes. */
  next(n: number, box: Box, tile: Box): Box {
    const before = this.before.get(n);
    this.before.set(n, box);
    return overlap(before === undefined ? box : union(before, box), tile);
  }
}
