/** Lips that meet go together: what a hand takes along of one near the corners of the mouth, it takes of the other. */

import type { Anatomy } from "../../../face/anatomy/anatomy";
import { minus, rowOf, size, type Triple } from "../math/vectors";

/** One lip's edge from corner to corner: its rows, and the share of the edge's length on the generic face before each. */
interface Edge {
  rows: Uint32Array;
  shares: Float64Array;
}

/** The edges of two lips that meet, both from the same corner of the mouth to the other. */
export type Lips = readonly [Edge, Edge];

/** The name of the line where lips meet. */
const LINE = "lips";
/** As shares of the edge from its nearer corner: up to the first what is dragged takes both lips along, from the second
 * on only its own; between them ever less of the other. */
const [CORNER, MIDDLE] = [0.2, 0.45];
/** Lips farther apart than this share of the mouth's width do not meet (at rest 0.12 at most, on all faces). */
const APART = 0.13;

const lipsByAnatomy = new WeakMap<Anatomy, Lips | null>();

/** The lips of a cast, found once; null: it has none. */
export function lipsOf(anatomy: Anatomy): Lips | null {
  const lips = lipsByAnatomy.get(anatomy) ?? halves(anatomy.lines.get(LINE), anatomy.positions);
  lipsByAnatomy.set(anatomy, lips);
  return lips;
}

/** The two halves of a closed line between the row farthest to one side and the row farthest to the other. */
export function halves(line: Uint32Array | undefined, positions: Float32Array): Lips | null {
  if (line === undefined || line.length < 4) return null;
  const across = [...line].map((row) => positions[3 * row] as number);
  const right = across.indexOf(Math.min(...across));
  const left = across.indexOf(Math.max(...across));
  const half = (step: 1 | -1): Edge => {
    const count = (step * (left - right) + line.length) % line.length;
    const at = (place: number): number => (right + step * place + line.length) % line.length;
    return edgeOf(
      Uint32Array.from({ length: count + 1 }, (_, place) => line[at(place)] as number),
      positions,
    );
  };
  return [half(1), half(-1)];
}

function edgeOf(rows: Uint32Array, positions: Float32Array): Edge {
  const shares = new Float64Array(rows.length);
  for (let place = 1; place < rows.length; place++) {
    const [a, b] = [rowOf(positions, rows[place - 1] as number), rowOf(positions, rows[place] as number)];
    shares[place] = (shares[place - 1] as number) + size(minus(b, a));
  }
  const whole = shares[rows.length - 1] as number;
  return { rows, shares: shares.map((share) => share / whole) };
}

/** Distances of rows along the skin from what is dragged, put right on the edges of the lips, in place: where these meet
 * a point is as near as the one across from it is. */
export function together(lips: Lips, far: Float32Array, positions: Float32Array): void {
  const measure = bond(lips, far);
  if (measure === 0) return;
  const [corner, other] = [lips[0].rows[0] as number, lips[0].rows.at(-1) as number];
  const width = size(minus(rowOf(positions, other), rowOf(positions, corner)));
  const before = far.slice();
  for (const [own, across] of [lips, [lips[1], lips[0]]] as const)
    own.rows.forEach((row, place) => {
      const { first, second, part } = at(across, own.shares[place] as number);
      const mixed = (a: number, b: number): number => a + part * (b - a);
      const [a, b] = [rowOf(positions, first), rowOf(positions, second)];
      const there: Triple = [mixed(a[0], b[0]), mixed(a[1], b[1]), mixed(a[2], b[2])];
      const gap = Math.max(0, size(minus(there, rowOf(positions, row))) - APART * width);
      const through = mixed(before[first] as number, before[second] as number) + gap;
      const straight = before[row] as number;
      far[row] = straight + measure * (Math.min(straight, through) - straight);
    });
}

/** How much both lips go together, 0..1, by where on the edges they are nearest to what is dragged. */
function bond(lips: Lips, far: Float32Array): number {
  let [least, side] = [Infinity, 0.5];
  for (const { rows, shares } of lips)
    rows.forEach((row, place) => {
      const share = shares[place] as number;
      if ((far[row] as number) < least) [least, side] = [far[row] as number, Math.min(share, 1 - share)];
    });
  const part = Math.min(1, Math.max(0, (MIDDLE - side) / (MIDDLE - CORNER)));
  return part * part * (3 - 2 * part);
}

/** The rows of an edge around a share of its length, and how far it lies from the first to the second. */
function at({ rows, shares }: Edge, share: number): { first: number; second: number; part: number } {
  let place = 0;
  while (place < rows.length - 2 && (shares[place + 1] as number) < share) place++;
  const [from, to] = [shares[place] as number, shares[place + 1] as number];
  const part = Math.min(1, Math.max(0, (share - from) / Math.max(to - from, 1e-12)));
  return { first: rows[place] as number, second: rows[place + 1] as number, part };
}
