/** Control points added, removed and set down elsewhere: the rows of the net that comes of it. */

import type { Net } from "../../session/control_net";
import { type Hit, nearestCorner } from "../math/hit_test";

/** The vertex of the sheet nearest to where a pointer met the skin, where no point stands yet; undefined: none. */
export const freeRow = (net: Net, met: Hit, positions: Float32Array): number | undefined =>
  nearestCorner(met, positions, (row) => onSheet(net.weights, row) && !net.rows.includes(row));

/** Whether a net carries anything at a row of the skin. */
const onSheet = (weights: Float32Array, row: number): boolean =>
  [0, 1, 2].some((corner) => (weights[3 * row + corner] ?? 0) !== 0);

export const withRow = (net: Net, row: number): number[] => [...net.rows, row];

export const withoutPlace = (net: Net, place: number): number[] => net.rows.filter((_, other) => other !== place);

/** The point of a place stands at another row. */
export const withPlaceAt = (net: Net, place: number, row: number): number[] =>
  net.rows.map((other, at) => (at === place ? row : other));
