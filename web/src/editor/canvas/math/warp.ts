/**
 * The sculptor's map of space: of all smooth maps through some points the one that bends least (|r|^3 with an affine
 * part; omote.model.sculpting.sculpt.warp), linear in the points' moves.
 */

import { WARP_UNIT } from "../../../link/constants";

const AFFINE = 4;

export class Warp {
  private readonly count: number;
  private readonly middle: [number, number, number];
  private readonly centres: Float64Array;
  /** The coefficients (n + 4) of each point's unit move, row by row of the points. */
  private readonly coefficients: Float64Array[];

  /** points (n, 3), metres; an Error with a sentence where they lie in one plane. */
  constructor(points: ArrayLike<number>) {
    this.count = points.length / 3;
    this.middle = meanOf(points);
    this.centres = Float64Array.from(
      { length: points.length },
      (_, at) => ((points[at] as number) - (this.middle[at % 3] as number)) / WARP_UNIT,
    );
    const size = this.count + AFFINE;
    const system = Array.from({ length: size }, (_, row) => this.equation(row));
    const units = Array.from({ length: size }, (_, row) =>
      Float64Array.from({ length: this.count }, (__, place) => (row === place ? 1 : 0)),
    );
    const solution = solvedMany(system, units);
    this.coefficients = Array.from({ length: this.count }, (_, place) =>
      Float64Array.from(solution, (row) => row[place] as number),
    );
  }

  /** How far each of some places (m, 3) follows one point: (m,). */
  follows(where: ArrayLike<number>, place: number): Float64Array {
    const out = new Float64Array(where.length / 3);
    this.sum(where, [this.coefficients[place] as Float64Array], out);
    return out;
  }

  /** Adds to `into` (m, 3) what moves (n, 3) of the points do to places (m, 3). */
  add(into: Float32Array, where: ArrayLike<number>, moves: ArrayLike<number>): void {
    this.sum(
      where,
      [0, 1, 2].map((axis) => this.total(moves, axis)),
      into,
    );
  }

  private total(moves: ArrayLike<number>, axis: number): Float64Array {
    const out = new Float64Array(this.count + AFFINE);
    this.coefficients.forEach((weights, place) => {
      const move = moves[3 * place + axis] as number;
      if (move !== 0)
        for (let at = 0; at < out.length; at++) out[at] = (out[at] as number) + move * (weights[at] as number);
    });
    return out;
  }

  /** Adds to `into` (m, k) the sums of kernel and affine part at places (m, 3), weighed by k lists (n + 4). */
  private sum(where: ArrayLike<number>, lists: readonly Float64Array[], into: Float32Array | Float64Array): void {
    const { count } = this;
    const columns = new Float64Array(count + AFFINE);
    for (let row = 0; 3 * row < where.length; row++) {
      this.writeColumns(where, row, columns);
      for (let list = 0; list < lists.length; list++) {
        const weights = lists[list] as Float64Array;
        let sum = 0;
        for (let place = 0; place < columns.length; place++)
          sum += (columns[place] as number) * (weights[place] as number);
        const at = lists.length * row + list;
        into[at] = (into[at] as number) + sum;
      }
    }
  }

  private writeColumns(where: ArrayLike<number>, row: number, into: Float64Array): void {
    const { centres, count, middle } = this;
    const x = ((where[3 * row] as number) - middle[0]) / WARP_UNIT;
    const y = ((where[3 * row + 1] as number) - middle[1]) / WARP_UNIT;
    const z = ((where[3 * row + 2] as number) - middle[2]) / WARP_UNIT;
    for (let place = 0; place < count; place++) {
      const a = x - (centres[3 * place] as number);
      const b = y - (centres[3 * place + 1] as number);
      const c = z - (centres[3 * place + 2] as number);
      const square = a * a + b * b + c * c;
      into[place] = square * Math.sqrt(square);
    }
    [into[count], into[count + 1], into[count + 2], into[count + 3]] = [1, x, y, z];
  }

  private equation(row: number): Float64Array {
    const { centres, count } = this;
    const out = new Float64Array(count + AFFINE);
    const affine = (place: number, part: number): number =>
      part === 0 ? 1 : (centres[3 * place + part - 1] as number);
    for (let place = 0; place < count; place++) {
      if (row >= count) out[place] = affine(place, row - count);
      else {
        const far = Math.hypot(
          ...[0, 1, 2].map((axis) => (centres[3 * row + axis] as number) - (centres[3 * place + axis] as number)),
        );
        out[place] = far ** 3;
      }
    }
    if (row < count) for (let part = 0; part < AFFINE; part++) out[count + part] = affine(row, part);
    return out;
  }
}

function meanOf(points: ArrayLike<number>): [number, number, number] {
  const sum: [number, number, number] = [0, 0, 0];
  for (let at = 0; at < points.length; at++) sum[at % 3] = (sum[at % 3] as number) + (points[at] as number);
  const count = Math.max(1, points.length / 3);
  return [sum[0] / count, sum[1] / count, sum[2] / count];
}

const LEAST_PIVOT = 1e-9;

/** The solutions (rows, k) of a square system (rows, rows) for k right sides, by elimination; both are used up. */
function solvedMany(system: Float64Array[], right: Float64Array[]): Float64Array[] {
  const size = system.length;
  for (let column = 0; column < size; column++) {
    let best = column;
    for (let row = column + 1; row < size; row++)
      if (Math.abs(at(system, row, column)) > Math.abs(at(system, best, column))) best = row;
    if (!(Math.abs(at(system, best, column)) > LEAST_PIVOT))
      throw new Error("These handles lie in one plane or on one spot; choose others.");
    for (const rows of [system, right])
      [rows[column], rows[best]] = [rows[best] as Float64Array, rows[column] as Float64Array];
    for (let row = 0; row < size; row++) {
      if (row === column) continue;
      const factor = at(system, row, column) / at(system, column, column);
      if (factor === 0) continue;
      for (const rows of [system, right]) subtract(rows[row] as Float64Array, rows[column] as Float64Array, factor);
    }
  }
  return right.map((values, row) => values.map((value) => value / at(system, row, row)));
}

const at = (rows: readonly Float64Array[], row: number, column: number): number =>
  (rows[row] as Float64Array)[column] as number;

function subtract(from: Float64Array, row: Float64Array, factor: number): void {
  for (let place = 0; place < from.length; place++)
    from[place] = (from[place] as number) - factor * (row[place] as number);
}
