/** What an editor works with, read from the wire into typed arrays: the net, muscles, regions, followers. */

import { aligned } from "../../link/arrays";
import type { Greeted, MuscleDocument, NetDocument } from "../../link/editing_messages";

export type Vector = [number, number, number];

/** A control point at rest: no turn, no height, on the surface. */
export const REST: Readonly<Vector> = [0, 0, 1];

/** A control net (`NetDocument`): the field at vertex v is the sum of `weights` times the vectors at `corners`. */
export interface Net {
  /** Rows of the skin under the points, (n,). */
  readonly rows: readonly number[];
  /** Places, (t, 3); from n on they belong to the ring, which rests. */
  readonly triangles: Uint16Array;
  /** Places, (V, 3). */
  readonly corners: Uint16Array;
  readonly weights: Float32Array;
  /** For each point the place of its mirror image, its own on the midline, -1 for none. */
  readonly mirror: readonly number[];
}

/** A muscle; `field`: (V, 3) at full contraction. */
export interface Muscle extends Omit<MuscleDocument, "field"> {
  readonly field: Float32Array;
}

/** Rows that follow the sheet: row `rows[f]` moves as the sum of `shares` times rows `anchors`, `links` for each. */
export interface Followers {
  readonly rows: Uint32Array;
  readonly anchors: Uint32Array;
  readonly shares: Float32Array;
  readonly links: number;
}

/** What a greeting tells that does not change while the page is open. */
export interface HeadControls {
  readonly muscles: readonly Muscle[];
  readonly regions: readonly string[];
  /** How much each region owns of each vertex, 255 all; one array for each region, in their order. */
  readonly masks: readonly Uint8Array[];
  readonly followers: Followers;
}

export function readNet(document: NetDocument): Net {
  return {
    rows: document.net,
    triangles: new Uint16Array(aligned(document.triangles)),
    corners: new Uint16Array(aligned(document.corners)),
    weights: new Float32Array(aligned(document.weights)),
    mirror: document.mirror,
  };
}

export function readHeadControls(greeted: Greeted): HeadControls {
  const rows = new Uint32Array(aligned(greeted.followers));
  const anchors = new Uint32Array(aligned(greeted.anchors));
  const size = greeted.regions.length === 0 ? 0 : greeted.masks.length / greeted.regions.length;
  return {
    muscles: greeted.muscles.map((muscle) => ({ ...muscle, field: new Float32Array(aligned(muscle.field)) })),
    regions: greeted.regions,
    masks: greeted.regions.map((_, place) => greeted.masks.slice(place * size, (place + 1) * size)),
    followers: {
      rows,
      anchors,
      shares: new Float32Array(aligned(greeted.shares)),
      links: rows.length === 0 ? 0 : anchors.length / rows.length,
    },
  };
}

/** Vectors one after another, (n, 3). */
export const flat = (vectors: readonly Readonly<Vector>[]): Float64Array => Float64Array.from(vectors.flat());

/** The vector of a place. */
export const vectorAt = (vectors: Float64Array, place: number): Vector => [
  vectors[3 * place] as number,
  vectors[3 * place + 1] as number,
  vectors[3 * place + 2] as number,
];

/** The inverse of `flat`. */
export const split = (vectors: Float64Array): Vector[] =>
  Array.from({ length: vectors.length / 3 }, (_, place) => vectorAt(vectors, place));

/** The muscle on the other side of the face, by name; one on the midline is its own twin. */
export const mirrorMuscle = (name: string): string =>
  name.replace(/_(left|right)$/, (_, side: string) => (side === "left" ? "_right" : "_left"));

/** The places of the same points in another net. */
export function keptPlaces(places: ReadonlySet<number>, from: Net | null, to: Net | null): number[] {
  const rows = new Set([...places].map((place) => from?.rows[place]));
  return (to?.rows ?? []).flatMap((row, place) => (rows.has(row) ? [place] : []));
}
