/** A body in a plain suit: cloth spans what lies hidden under it. */

import { type Body, type FigureSpace, ROW_BONES } from "../../link/figures";

/** Smoothing that keeps the volume: a step in, and one out a little farther (G. Taubin, "A signal processing approach to
 * fair surface design", 1995). */
const [INWARD, OUTWARD] = [0.6, -0.62];
const ROUNDS = 24;

/** The bones of trunk and hips, whose relief cloth spans. */
const SPANNED = /^(root|spine|pelvis|upperleg01)/;

/** How much each row of a body (B,) is smoothed, 0..1. */
export function spannedRows({ bones, rowBones, rowWeights, headRows, bodyRows, joined }: FigureSpace): Float32Array {
  const of = bones.map((name) => SPANNED.test(name));
  const share = Float32Array.from({ length: bodyRows }, (_, row) => {
    let sum = 0;
    for (let at = ROW_BONES * (headRows + row); at < ROW_BONES * (headRows + row + 1); at++)
      if (of[rowBones[at] as number]) sum += (rowWeights[at] as number) / 65535;
    return sum;
  });
  for (const row of joined) share[row] = 0; // the neck is its face's
  return share;
}

/** The rows of a body (B, 3), metres, as a suit covers them. */
export function dressed(space: FigureSpace, { positions }: Body): Float32Array {
  const share = spannedRows(space);
  const neighbours = neighboursOf(space);
  let [from, to] = [positions.slice(), positions.slice()];
  for (let round = 0; round < 2 * ROUNDS; round++) {
    const step = round % 2 === 0 ? INWARD : OUTWARD;
    share.forEach((part, row) => {
      if (part > 0) stepRow(from, to, row, neighbours[row] as readonly number[], step * part);
    });
    [from, to] = [to, from];
    if (round === 0) to.set(from); // rows that stay are the same in both
  }
  return from;
}

/** Moves a row part of the way to the middle of its neighbours. */
function stepRow(from: Float32Array, to: Float32Array, row: number, around: readonly number[], part: number): void {
  for (let axis = 0; axis < 3; axis++) {
    const here = from[3 * row + axis] as number;
    let sum = 0;
    for (const other of around) sum += from[3 * other + axis] as number;
    to[3 * row + axis] = here + part * (sum / around.length - here);
  }
}

/** The rows of the body beside each of its rows. */
function neighboursOf({ triangles, headRows, bodyRows }: FigureSpace): readonly (readonly number[])[] {
  const sets = Array.from({ length: bodyRows }, () => new Set<number>());
  for (let at = 0; at < triangles.length; at++) {
    const first = at - (at % 3);
    const [row, other] = [triangles[at] as number, triangles[first + ((at + 1) % 3)] as number];
    if (row < headRows || other < headRows) continue;
    sets[row - headRows]?.add(other - headRows);
    sets[other - headRows]?.add(row - headRows);
  }
  return sets.map((set) => [...set]);
}
