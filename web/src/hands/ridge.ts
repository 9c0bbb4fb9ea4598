/** Ridge regression: many numbers in, a few out, by least squares that shrinks what the samples do not tell. */

/** What makes numbers of one size: their means, and one over their spreads (0 for what never varies). */
export interface Normalization {
  means: number[];
  scales: number[];
}

/** A fitted map. Each output is its offset and the weighted numbers, these about their means and in units of their spread. */
export interface Ridge extends Normalization {
  offsets: number[];
  weights: number[][];
}

/** The means and spreads of some samples of equal length. */
export function normalize(inputs: readonly ArrayLike<number>[]): Normalization {
  const means = Array.from({ length: inputs[0]?.length ?? 0 }, (_, place) => mean(inputs, place));
  const scales = means.map((middle, place) => {
    let square = 0;
    for (const row of inputs) square += ((row[place] ?? 0) - middle) ** 2;
    const spread = Math.sqrt(square / Math.max(inputs.length, 1));
    return spread > 1e-6 ? 1 / spread : 0;
  });
  return { means, scales };
}

/** A sample about the means, in units of the spread. */
export const normal = ({ means, scales }: Normalization, row: ArrayLike<number>): Float64Array =>
  Float64Array.from(means, (middle, place) => ((row[place] ?? 0) - middle) * (scales[place] ?? 0));

/** The normal equations of some inputs, solved for as many outputs as are asked for. */
export class RidgeFit {
  readonly #normalization: Normalization;
  readonly #rows: Float64Array[];
  readonly #factor: Float64Array[];

  /** inputs: samples of equal length; shrink: how much is added to the diagonal, of the count of samples. */
  constructor(inputs: readonly ArrayLike<number>[], shrink: number) {
    this.#normalization = normalize(inputs);
    this.#rows = inputs.map((row) => normal(this.#normalization, row));
    this.#factor = cholesky(gram(this.#rows, this.#normalization.means.length), shrink * inputs.length + 1e-9);
  }

  /** The map to outputs, one row for each; wanted: of each output, a value for each sample. */
  solve(wanted: readonly ArrayLike<number>[]): Ridge {
    const offsets = wanted.map((values) => sumOf(values) / Math.max(values.length, 1));
    const weights = wanted.map((values, output) => {
      const right = new Float64Array(this.#factor.length);
      this.#rows.forEach((row, sample) => {
        const value = (values[sample] ?? 0) - (offsets[output] ?? 0);
        for (let place = 0; place < right.length; place++)
          right[place] = (right[place] ?? 0) + (row[place] ?? 0) * value;
      });
      return [...substitute(this.#factor, right)];
    });
    return { ...this.#normalization, offsets, weights };
  }
}

/** What a map makes of one sample. */
export function applyRidge({ means, scales, offsets, weights }: Ridge, input: ArrayLike<number>): number[] {
  return weights.map((row, output) => {
    let sum = offsets[output] ?? 0;
    for (let place = 0; place < row.length; place++) {
      sum += (row[place] ?? 0) * ((input[place] ?? 0) - (means[place] ?? 0)) * (scales[place] ?? 0);
    }
    return sum;
  });
}

/** The correlation of two series, 0 where one of them does not vary. */
export function correlation(first: ArrayLike<number>, second: ArrayLike<number>): number {
  const count = Math.min(first.length, second.length);
  const [a, b] = [sumOf(first) / count, sumOf(second) / count];
  let [both, left, right] = [0, 0, 0];
  for (let place = 0; place < count; place++) {
    const [x, y] = [(first[place] ?? 0) - a, (second[place] ?? 0) - b];
    both += x * y;
    left += x * x;
    right += y * y;
  }
  return left > 0 && right > 0 ? both / Math.sqrt(left * right) : 0;
}

/** The sum of the products of two rows: of their first `count` values, by default of all in the first. */
export function dot(first: ArrayLike<number>, second: ArrayLike<number>, count = first.length): number {
  let sum = 0;
  for (let place = 0; place < count; place++) sum += (first[place] as number) * (second[place] as number);
  return sum;
}

/** The sum of some values. */
export function sumOf(values: ArrayLike<number>): number {
  let sum = 0;
  for (let place = 0; place < values.length; place++) sum += values[place] ?? 0;
  return sum;
}

function mean(rows: readonly ArrayLike<number>[], place: number): number {
  let sum = 0;
  for (const row of rows) sum += row[place] ?? 0;
  return sum / Math.max(rows.length, 1);
}

/** The products of the columns of some rows with each other, lower half. */
export function gram(rows: readonly Float64Array[], size: number): Float64Array[] {
  const sums = Array.from({ length: size }, () => new Float64Array(size));
  for (const row of rows) {
    for (let line = 0; line < size; line++) {
      const [value, sum] = [row[line] as number, sums[line] as Float64Array];
      for (let place = 0; place <= line; place++) sum[place] = (sum[place] as number) + value * (row[place] as number);
    }
  }
  return sums;
}

/** The lower factor of a symmetric matrix (its lower half is read) with something added to its diagonal. */
export function cholesky(matrix: readonly Float64Array[], added: number): Float64Array[] {
  const factor = matrix.map((row) => Float64Array.from(row));
  factor.forEach((row, line) => {
    for (let place = 0; place <= line; place++) {
      const other = factor[place] ?? row;
      const sum = (row[place] ?? 0) + (place === line ? added : 0) - dot(row, other, place);
      row[place] = place === line ? Math.sqrt(Math.max(sum, 1e-12)) : sum / (other[place] ?? 1);
    }
  });
  return factor;
}

/** What a factor's matrix makes the right side of. */
export function substitute(factor: readonly Float64Array[], right: Float64Array): Float64Array {
  const values = Float64Array.from(right);
  const size = values.length;
  for (let line = 0; line < size; line++) {
    const row = factor[line];
    let sum = values[line] ?? 0;
    for (let place = 0; place < line; place++) sum -= (row?.[place] ?? 0) * (values[place] ?? 0);
    values[line] = sum / (row?.[line] ?? 1);
  }
  for (let line = size - 1; line >= 0; line--) {
    let sum = values[line] ?? 0;
    for (let below = line + 1; below < size; below++) sum -= (factor[below]?.[line] ?? 0) * (values[below] ?? 0);
    values[line] = sum / (factor[line]?.[line] ?? 1);
  }
  return values;
}
