/** A body in a plain suit: cloth spans what lies hidden under it. */

import { type Body, type FigureSpace, ROW_BONES } from "../../link/figures";

/** Smoothing that keeps the volume: a step in, and one out a little farther (G. Taubin, "A signal processing approach to
 * fair surface design", 1995). */
const [INWARD, OUTWARD] = [0.6, -0.62];
const ROUNDS = 48;

/** Rounds, one after the other all inward, in which rows that lie closer than others become as flat as what is around them;
 * metres between neighbours up to which all of them do, and from which on none. */
const FLAT_ROUNDS = 60;
const [CLOSE, APART] = [0.008, 0.012];

/** Rounds that round off toes as thin shoes do, one after the other all inward. */
const SHOE_ROUNDS = 16;
const TOES = /^toes/;

/** The bones of trunk and hips, whose relief cloth spans. */
const SPANNED = /^(root|spine|pelvis|upperleg01)/;

/** How much of each row of a body (B,) bones of these names move, 0..1; none of those of a skirt or that follow a head. */
function movedBy(
  { bones, rowBones, rowWeights, headRows, bodyRows, joined, firstOfSkirt }: FigureSpace,
  names: RegExp,
): Float32Array {
  const of = bones.map((name) => names.test(name));
  const share = Float32Array.from({ length: bodyRows }, (_, row) => {
    let sum = 0;
    for (let at = ROW_BONES * (headRows + row); at < ROW_BONES * (headRows + row + 1); at++)
      if (of[rowBones[at] as number]) sum += (rowWeights[at] as number) / 65535;
    return sum;
  });
  for (const row of joined) share[row] = 0;
  share.fill(0, firstOfSkirt - headRows);
  return share;
}

/** What gives the rows of bodies (B, 3), metres, as a suit and shoes cover them; `first`: the body that others are shaped from. */
export function suitFor(space: FigureSpace, first: Body): (body: Body) => Float32Array {
  const neighbours = neighboursOf(space);
  const [trunk, toes] = [movedBy(space, SPANNED), movedBy(space, TOES)];
  const close = trunk.map((part, row) => part * closeness(first.positions, row, neighbours[row] as readonly number[]));
  const spanning = Array.from({ length: 2 * ROUNDS }, (_, round) => (round % 2 === 0 ? INWARD : OUTWARD));
  const inward = (rounds: number): number[] => new Array<number>(rounds).fill(INWARD);
  return ({ positions }) => {
    const flat = smoothed(positions, close, neighbours, inward(FLAT_ROUNDS));
    const spanned = smoothed(flat, trunk, neighbours, spanning);
    return smoothed(spanned, toes, neighbours, inward(SHOE_ROUNDS));
  };
}

/** How close a row lies to its neighbours, 0..1. */
function closeness(positions: Float32Array, row: number, around: readonly number[]): number {
  let sum = 0;
  for (const other of around) {
    const [x, y, z] = [0, 1, 2].map(
      (axis) => (positions[3 * row + axis] as number) - (positions[3 * other + axis] as number),
    ) as [number, number, number];
    sum += Math.hypot(x, y, z);
  }
  const mean = sum / around.length;
  return Math.min(1, Math.max(0, (APART - mean) / (APART - CLOSE)));
}

/** Rows that steps towards the middle of their neighbours have smoothed, each by its share. */
function smoothed(
  positions: Float32Array,
  shares: Float32Array,
  neighbours: readonly (readonly number[])[],
  steps: readonly number[],
): Float32Array {
  let [from, to] = [positions.slice(), positions.slice()];
  const rows = Array.from(shares.keys()).filter((row) => (shares[row] as number) > 0);
  for (const step of steps) {
    for (const row of rows)
      stepRow(from, to, row, neighbours[row] as readonly number[], step * (shares[row] as number));
    [from, to] = [to, from];
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
