/** Reads the manifest's document of corrective shapes into arrays for the GPU. */

import { aligned } from "../../link/arrays";
import { RUNGS } from "../../link/constants";
import type { CorrectivesDocument } from "../../link/messages";

/** Texels in a line of every texture of the correctives. */
export const DATA_WIDTH = 128;

/** How sums are corrected (omote.perform.blending.correctives), ready for the GPU: all counts in places of `rows`. */
export interface CorrectivesData {
  document: CorrectivesDocument;
  /** Rows of the positions that may move. */
  rows: Uint32Array;
  /** Per place: its line (-1: none), side, share, and 0. */
  pulls: Float32Array;
  /** Per place: its eye counted from 1 (0: none), its place in an allowance, first and end of its corners. */
  spans: Uint32Array;
  /** Per corner: the other two places in winding order, the triangle, and 0. */
  corners: Uint32Array;
  /** Per triangle: its places, and 0. */
  triangles: Uint32Array;
  /** Per rung: its four places; and their weights. */
  rungs: Uint32Array;
  rungWeights: Float32Array;
  /** Per line: 1 where it opens upward, else 0. */
  upward: Float32Array;
  followers: Uint32Array;
  /** Per follower: (place, weight) pairs, `width` of them. */
  anchors: Float32Array;
  width: number;
  /** Triangles of patches, patch after patch, and 0 behind each; per patch: the first of them and the end. */
  patchTriangles: Uint32Array;
  patches: Uint32Array;
  /** Per place: (patch, share) pairs, `rowPatches` of them. */
  members: Float32Array;
  rowPatches: number;
  /** Numbers in an allowance. */
  size: number;
}

const whole = (bytes: Uint8Array): Uint32Array => new Uint32Array(aligned(bytes));
const real = (bytes: Uint8Array): Float32Array => new Float32Array(aligned(bytes));

/** The correctives from their document; an Error when it points past its own rows. */
export function readCorrectives(document: CorrectivesDocument): CorrectivesData {
  const rows = whole(document.rows);
  const triangles = whole(document.triangles);
  if (triangles.some((place) => place >= rows.length))
    throw new Error(`The correctives' triangles point past its ${rows.length} rows; bake the cast again.`);
  const firstLid = triangles.length / 3 + RUNGS * document.crossings.length;
  const followers = whole(document.followers);
  return {
    document,
    rows,
    pulls: readPulls(document, rows.length),
    ...readCorners(triangles, readEyes(document, rows.length, firstLid)),
    triangles: inFours(triangles),
    ...readRungs(document),
    followers,
    anchors: readPairs(document.anchors, document.weights),
    ...readPatches(document, rows.length),
    width: followers.length === 0 ? 0 : document.anchors.length / 4 / followers.length,
    size: firstLid + document.lids.length / 4,
  };
}

function readPulls({ crossings }: CorrectivesDocument, count: number): Float32Array {
  const pulls = new Float32Array(4 * count).map((_, at) => (at % 4 === 0 ? -1 : 0));
  crossings.forEach((crossing, line) => {
    const [side, share] = [real(crossing.side), real(crossing.share)];
    whole(crossing.near).forEach((place, n) => {
      pulls.set([line, side[n] as number, share[n] as number], 4 * place);
    });
  });
  return pulls;
}

/** Per place four numbers: its eye from 1 on, its place in an allowance, and room for two more. */
function readEyes(document: CorrectivesDocument, count: number, first: number): Uint32Array {
  const spans = new Uint32Array(4 * count);
  const eye = whole(document.eye);
  whole(document.lids).forEach((place, n) => {
    spans.set([(eye[n] as number) + 1, first + n], 4 * place);
  });
  return spans;
}

function readCorners(triangles: Uint32Array, spans: Uint32Array): Pick<CorrectivesData, "spans" | "corners"> {
  const count = spans.length / 4;
  const ends = new Uint32Array(count + 1);
  for (const place of triangles) ends[place + 1] = (ends[place + 1] as number) + 1;
  for (let place = 0; place < count; place++) ends[place + 1] = (ends[place + 1] as number) + (ends[place] as number);
  for (let place = 0; place < count; place++)
    spans.set([ends[place] as number, ends[place + 1] as number], 4 * place + 2);
  const filled = ends.slice(0, count);
  const corners = new Uint32Array(4 * triangles.length);
  triangles.forEach((place, at) => {
    const first = at - (at % 3);
    const slot = filled[place] as number;
    filled[place] = slot + 1;
    const others = [1, 2].map((step) => triangles[first + ((at + step) % 3)] as number);
    corners.set([...others, first / 3], 4 * slot);
  });
  return { spans, corners };
}

/** Triples with a zero behind each. */
function inFours(triples: Uint32Array): Uint32Array {
  const fours = new Uint32Array((4 * triples.length) / 3);
  for (let at = 0; at < triples.length / 3; at++) fours.set(triples.subarray(3 * at, 3 * at + 3), 4 * at);
  return fours;
}

function readRungs({ crossings }: CorrectivesDocument): Pick<CorrectivesData, "rungs" | "rungWeights" | "upward"> {
  const rungs = new Uint32Array(4 * RUNGS * crossings.length);
  const rungWeights = new Float32Array(rungs.length);
  crossings.forEach((crossing, line) => {
    rungs.set(whole(crossing.vertices), 4 * RUNGS * line);
    rungWeights.set(real(crossing.weights), 4 * RUNGS * line);
  });
  return { rungs, rungWeights, upward: Float32Array.from(crossings, ({ upward }) => (upward ? 1 : 0)) };
}

/** Whole numbers, each with its weight behind it. */
function readPairs(numbers: Uint8Array, weights: Uint8Array): Float32Array {
  const [places, shares] = [whole(numbers), real(weights)];
  const pairs = new Float32Array(2 * places.length);
  places.forEach((place, n) => {
    pairs.set([place, shares[n] as number], 2 * n);
  });
  return pairs;
}

type Patches = Pick<CorrectivesData, "patchTriangles" | "patches" | "members" | "rowPatches">;

function readPatches(document: CorrectivesDocument, count: number): Patches {
  const [triangles, last] = [whole(document.patch_triangles), whole(document.patch_ends)];
  return {
    patchTriangles: new Uint32Array(2 * triangles.length).map((_, at) =>
      at % 2 === 0 ? (triangles[at / 2] as number) : 0,
    ),
    patches: Uint32Array.from([...last].flatMap((end, n) => [n === 0 ? 0 : (last[n - 1] as number), end])),
    members: readPairs(document.row_patches, document.row_shares),
    rowPatches: document.row_patches.length / 4 / count,
  };
}

/** Per row of the positions: its place counted from 1 (0: none), and which follower it is, from 1 on. */
export function rolesOf({ rows, followers }: CorrectivesData, count: number): Uint32Array {
  const roles = new Uint32Array(2 * count);
  rows.forEach((row, place) => {
    roles[2 * row] = place + 1;
  });
  followers.forEach((row, follower) => {
    roles[2 * row + 1] = follower + 1;
  });
  return roles;
}
