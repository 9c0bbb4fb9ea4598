import type { SettlingDocument } from "../link/messages";

export const RUNGS = 32;

/** How sums are put right (omote.perform.settle), ready for the GPU; rows are rows of the positions. */
export interface Settling {
  document: SettlingDocument;
  /** Rows that may move. */
  rows: Uint32Array;
  /** Per row: its line (-1: none), side and share. */
  pulls: Float32Array;
  /** Per row: its eye (-1: none) and its place in an allowance. */
  lids: Int32Array;
  /** Per row: first and end of its corners. */
  spans: Uint32Array;
  /** Per corner: the other two rows in winding order, the triangle, and 0. */
  corners: Uint32Array;
  /** Per triangle: its rows, and 0. */
  triangles: Uint32Array;
  /** Per rung: its four rows; and their weights. */
  rungRows: Uint32Array;
  rungWeights: Float32Array;
  /** Per line: 1 where it opens upward, else 0. */
  upward: Float32Array;
  followers: Uint32Array;
  /** Per follower: (row, weight) pairs, `width` of them. */
  anchors: Float32Array;
  width: number;
  /** Numbers in an allowance. */
  size: number;
}

const aligned = (bytes: Uint8Array): ArrayBuffer => bytes.slice().buffer as ArrayBuffer; // a view's offset may be odd
const whole = (bytes: Uint8Array): Uint32Array => new Uint32Array(aligned(bytes));
const real = (bytes: Uint8Array): Float32Array => new Float32Array(aligned(bytes));

/** A settling from its document; an Error when it points past its own rows. */
export function readSettling(document: SettlingDocument): Settling {
  const rows = whole(document.rows);
  const places = whole(document.triangles);
  if (places.some((place) => place >= rows.length))
    throw new Error(`The settling's triangles point past its ${rows.length} rows; bake the cast again.`);
  const lines = document.crossings.length;
  return {
    document,
    rows,
    pulls: readPulls(document, rows.length),
    lids: readLids(document, rows.length, places.length / 3 + RUNGS * lines),
    ...readTriangles(places, rows),
    ...readRungs(document, rows),
    ...readFollowers(document, rows),
    size: places.length / 3 + RUNGS * lines + document.lids.length / 4,
  };
}

function readPulls({ crossings }: SettlingDocument, count: number): Float32Array {
  const pulls = new Float32Array(3 * count).map((_, at) => (at % 3 === 0 ? -1 : 0));
  crossings.forEach((crossing, line) => {
    const [side, share] = [real(crossing.side), real(crossing.share)];
    whole(crossing.near).forEach((place, n) => {
      pulls.set([line, side[n] as number, share[n] as number], 3 * place);
    });
  });
  return pulls;
}

function readLids(document: SettlingDocument, count: number, first: number): Int32Array {
  const lids = new Int32Array(2 * count).fill(-1);
  const eye = whole(document.eye);
  whole(document.lids).forEach((place, n) => {
    lids.set([eye[n] as number, first + n], 2 * place);
  });
  return lids;
}

function readTriangles(places: Uint32Array, rows: Uint32Array): Pick<Settling, "spans" | "corners" | "triangles"> {
  const counts = new Uint32Array(rows.length);
  for (const place of places) counts[place] = (counts[place] as number) + 1;
  const spans = new Uint32Array(2 * rows.length);
  let end = 0;
  counts.forEach((count, place) => {
    spans.set([end, end + count], 2 * place);
    end += count;
  });
  const filled = Uint32Array.from(rows, (_, place) => spans[2 * place] as number);
  const corners = new Uint32Array(4 * places.length);
  const row = (at: number): number => rows[places[at] as number] as number;
  places.forEach((place, at) => {
    const first = at - (at % 3);
    const slot = filled[place] as number;
    filled[place] = slot + 1;
    corners.set([row(first + ((at + 1) % 3)), row(first + ((at + 2) % 3)), first / 3, 0], 4 * slot);
  });
  const triangles = new Uint32Array((4 * places.length) / 3);
  places.forEach((_, at) => {
    triangles[4 * Math.floor(at / 3) + (at % 3)] = row(at);
  });
  return { spans, corners, triangles };
}

function readRungs(
  { crossings }: SettlingDocument,
  rows: Uint32Array,
): Pick<Settling, "rungRows" | "rungWeights" | "upward"> {
  const rungRows = new Uint32Array(4 * RUNGS * crossings.length);
  const rungWeights = new Float32Array(rungRows.length);
  crossings.forEach((crossing, line) => {
    rungRows.set(
      whole(crossing.vertices).map((place) => rows[place] as number),
      4 * RUNGS * line,
    );
    rungWeights.set(real(crossing.weights), 4 * RUNGS * line);
  });
  return { rungRows, rungWeights, upward: Float32Array.from(crossings, ({ upward }) => (upward ? 1 : 0)) };
}

function readFollowers(
  document: SettlingDocument,
  rows: Uint32Array,
): Pick<Settling, "followers" | "anchors" | "width"> {
  const followers = whole(document.followers);
  const [places, weights] = [whole(document.anchors), real(document.weights)];
  const anchors = new Float32Array(2 * places.length);
  places.forEach((place, n) => {
    anchors.set([rows[place] as number, weights[n] as number], 2 * n);
  });
  return { followers, anchors, width: followers.length === 0 ? 0 : places.length / followers.length };
}
