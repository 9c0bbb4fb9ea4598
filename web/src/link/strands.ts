/** Reads a hair style's strands. */

import { aligned } from "./arrays";
import type { HairAsset } from "./messages";

/** Strands of hair on the generic face; n strands of `stations` places, root to tip. */
export interface HairStrands {
  stations: number;
  /** Rows of the skin that carry one place. */
  links: number;
  /** Metres, of a strand's ribbon. */
  width: number;
  /** Metres, (n, stations, 3). */
  points: Float32Array;
  /** (n, stations, links): rows of the skin, and their weights, which sum to one for each place. */
  rows: Uint32Array;
  weights: Float32Array;
  /** (n,): the row of the skin at each root. */
  anchors: Uint32Array;
  /** (n, stations, 3): away from the head, 127 is one. */
  facing: Int8Array;
  /** (n, stations): open sky, 255 is one. */
  light: Uint8Array;
  /** (n,): of the width, 0..1. */
  fullness: Float32Array;
}

/** Strands as typed arrays; an Error when they do not belong to a skin of `skin` rows, or to each other. */
export function readStrands(asset: HairAsset, skin: number): HairStrands {
  const { stations, links, width } = asset;
  const points = Float32Array.from(new Int16Array(aligned(asset.points)), (count) => count * asset.scale);
  const rows = new Uint32Array(aligned(asset.rows));
  const anchors = new Uint32Array(aligned(asset.anchors));
  const counts = new Uint8Array(aligned(asset.weights));
  const places = anchors.length * stations;
  const lengths = [points.length / 3, rows.length / links, counts.length / links, asset.light.length];
  if (
    !lengths.every((length) => length === places) ||
    asset.facing.length !== 3 * places ||
    asset.fullness.length !== anchors.length
  )
    throw new Error(`A hair style of ${anchors.length} strands has arrays of other lengths; bake the cast again.`);
  if (stations < 3) throw new Error(`A hair style has strands of ${stations} places; bake it with 3 or more.`);
  if (rows.some((row) => row >= skin) || anchors.some((row) => row >= skin))
    throw new Error(`A hair style points past the skin's ${skin} rows; bake the cast again.`);
  return {
    stations,
    links,
    width,
    points,
    rows,
    weights: shares(counts, links),
    anchors,
    facing: new Int8Array(aligned(asset.facing)),
    light: new Uint8Array(aligned(asset.light)),
    fullness: Float32Array.from(new Uint8Array(aligned(asset.fullness)), (count) => count / 255),
  };
}

function shares(counts: Uint8Array, links: number): Float32Array {
  return Float32Array.from(counts, (count, at) => {
    const first = at - (at % links);
    return count / counts.subarray(first, first + links).reduce((sum, other) => sum + other, 0);
  });
}
