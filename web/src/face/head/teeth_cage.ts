/** The rows of a row of teeth as a cage: columns along the arch, in which the drawn teeth keep their places. */

import type { Mesh } from "../../link/assets";
import { ARCH } from "../../link/constants";

/** Rows of a column: at the gum and halfway on the outer side, at the edge, and behind. */
export const COLUMN_ROWS = 4;
/** Columns of the cage, from the character's right to its left. */
export const COLUMNS = 17;

/** A row of teeth as the cast has it: gum, middle, edge and behind of each column, from the right end to the left one. */
export type Column = readonly [gum: number, middle: number, edge: number, behind: number];

/** A point in the cage: column (0..16), steps from edge to gum, steps from outside to behind. */
export type CagePlace = readonly [column: number, up: number, inward: number];

type Point = readonly [number, number, number];

/**
 * The columns of a row of teeth, by its rows alone: those behind lie nearest to the arch's middle, the others in threes at
 * one angle. undefined where it is no such strip (a cast of somebody else's), which is drawn as it is.
 * `positions`: the generic face; `arch`: metres from the front teeth to the middle of the arch.
 */
export function cageColumns(
  rows: readonly number[],
  positions: Float32Array,
  upper: boolean,
  arch: number,
): Column[] | undefined {
  if (rows.length !== COLUMN_ROWS * COLUMNS) return undefined;
  const at = (row: number, axis: number) => positions[3 * row + axis] as number;
  const middle = Math.max(...rows.map((row) => at(row, 2))) - arch;
  const reach = (row: number) => Math.hypot(at(row, 0), at(row, 2) - middle);
  const angle = (row: number) => Math.atan2(at(row, 0), at(row, 2) - middle);
  const outwards = [...rows].sort((a, b) => reach(a) - reach(b));
  const behind = outwards.slice(0, COLUMNS).sort((a, b) => angle(a) - angle(b));
  const outer = outwards.slice(COLUMNS).sort((a, b) => angle(a) - angle(b));
  return behind.map((last, n) => {
    const column = outer.slice(3 * n, 3 * n + 3).sort((a, b) => (upper ? 1 : -1) * (at(b, 1) - at(a, 1)));
    return [...column, last] as unknown as Column;
  });
}

/** Shares of four neighbouring columns at a place between the middle two (E. Catmull and R. Rom, 1974); `t`: 0..1. */
export const splineShares = (t: number): readonly [number, number, number, number] => [
  t * (-0.5 + t * (1 - 0.5 * t)),
  1 + t * t * (1.5 * t - 2.5),
  t * (0.5 + t * (2 - 1.5 * t)),
  t * t * (0.5 * t - 0.5),
];

/** Where a place in the cage lies, as the shaders find it too; `positions`: metres. */
export function cagePoint(columns: readonly Column[], positions: Float32Array, [column, up, inward]: CagePlace): Point {
  const first = Math.min(Math.floor(column), COLUMNS - 2);
  const shares = splineShares(column - first);
  const weights = [up, -inward, 1 - up, inward]; // gum, middle, edge, behind
  const point = [0, 0, 0];
  shares.forEach((share, n) => {
    const rows = columns[Math.min(Math.max(first - 1 + n, 0), COLUMNS - 1)] as Column;
    rows.forEach((row, part) => {
      for (const axis of [0, 1, 2])
        point[axis] =
          (point[axis] as number) + share * (weights[part] as number) * (positions[3 * row + axis] as number);
    });
  });
  return point as unknown as Point;
}

/** The cages of both rows of teeth, where a cast has such. */
export interface Cages {
  readonly upper: readonly Column[] | undefined;
  readonly lower: readonly Column[] | undefined;
}

/** The cages of a cast. */
export function cagesOf(meshes: readonly Mesh[], positions: Float32Array): Cages {
  const cage = (name: string) => {
    const rows = new Set(meshes.find((mesh) => mesh.name === name)?.source);
    return cageColumns([...rows], positions, name === "teeth_upper", ARCH);
  };
  return { upper: cage("teeth_upper"), lower: cage("teeth_lower") };
}
