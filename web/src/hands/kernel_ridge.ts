/**
 * Kernel ridge regression: a map that bends where the samples say so, and goes on straight where there were none.
 * Source: A. J. Smola, P. L. Bartlett, Sparse Greedy Gaussian Process Regression, NIPS 2000 (the subset of regressors).
 */

import { cholesky, correlation, dot, gram, type Normalization, normal, normalize, substitute, sumOf } from "./ridge";

/** A fitted map. Each output is its offset and the weighted kernels between what is read and the supports. */
export interface KernelMap extends Normalization {
  /** Samples, about their means and in units of their spread. */
  supports: number[][];
  offsets: number[];
  /** Of each output, one for each support. */
  weights: number[][];
}

/** A fit. */
export interface KernelFit {
  map: KernelMap;
  /** Of each output, how well it was foretold from samples that were held out: a correlation. */
  foretold: number[];
}

/** Supports at most; with 300 the curl of a hidden finger is read with r .01 less, with twice as many no better. */
const MOST_SUPPORTS = 400;
/** And while prices are tried: each takes the cube of it. */
const FEW_SUPPORTS = 150;
/** How fast the bent part of the kernel falls: by the mean square of the inputs' distances, in units of their spread. */
const FALL = 0.3;
/** What is tried as the price of large weights. */
const PRICES = [0.03, 0.1, 0.3, 1];
/** Of the least error that any price gives: so much more is borne for a higher price. */
const SLACK = 0.03;
/** Parts of the samples, each of which is foretold from the others. */
const FOLDS = 5;
/** Added to the diagonal, of the count of samples: two supports may be nearly one. */
const LEAST = 1e-9;

/** Some samples' part in the least squares: the kernels' products with each other, and with each output. */
interface Equations {
  left: Float64Array[];
  right: Float64Array[];
}

/**
 * The map to some outputs. The price of an output's weights is the highest that foretells well what was held out: who
 * does not do quite what was asked of them needs a high one.
 *
 * inputs: samples of equal length; stretches: of each, the number of its stretch of time, which is held out as a whole,
 * since its samples are alike; wanted: of each output, a value for each sample.
 */
export function fitKernel(
  inputs: readonly ArrayLike<number>[],
  stretches: readonly number[],
  wanted: readonly ArrayLike<number>[],
): KernelFit {
  const normalization = normalize(inputs);
  const samples = inputs.map((input) => normal(normalization, input));
  const offsets = wanted.map((values) => sumOf(values) / values.length);
  const ways = wanted.map((values, output) => Float64Array.from(values, (value) => value - (offsets[output] ?? 0)));
  const { prices, foretold } = choosePrices(new Regression(samples, ways, FEW_SUPPORTS), stretches);
  const regression = new Regression(samples, ways, MOST_SUPPORTS);
  const whole = regression.equations([...samples.keys()]);
  const solved = new Map([...new Set(prices)].map((price) => [price, regression.solve(whole, price)]));
  const weights = prices.map((price, output) => [...(solved.get(price)?.[output] ?? [])]);
  return { map: { ...normalization, supports: regression.supports, offsets, weights }, foretold };
}

/** What a map makes of one sample. */
export function applyKernel(
  { supports, offsets, weights, ...normalization }: KernelMap,
  input: ArrayLike<number>,
): number[] {
  const row = kernels(supports, normal(normalization, input));
  return weights.map((line, output) => (offsets[output] ?? 0) + dot(line, row));
}

/** The kernel between a sample and each support: a straight part, and one that falls with the distance. */
function kernels(supports: readonly ArrayLike<number>[], sample: ArrayLike<number>): Float64Array {
  const own = dot(sample, sample);
  return Float64Array.from(supports, (support) => {
    const product = dot(support, sample);
    const square = dot(support, support) + own - 2 * product;
    return (product + sample.length * Math.exp((-FALL * square) / sample.length)) / sample.length;
  });
}

/** The least squares of some samples by some supports among them. */
class Regression {
  readonly supports: number[][];
  readonly #rows: Float64Array[];
  readonly #between: Float64Array[];

  /** ways: of each output, a value for each sample, about its mean; most: supports. */
  constructor(
    samples: readonly Float64Array[],
    readonly ways: readonly Float64Array[],
    most: number,
  ) {
    const count = Math.min(most, samples.length);
    this.supports = Array.from({ length: count }, (_, place) =>
      Array.from(samples[Math.floor((place * samples.length) / count)] ?? [], rounded),
    );
    this.#rows = samples.map((sample) => kernels(this.supports, sample));
    this.#between = this.supports.map((support) => kernels(this.supports, support));
  }

  /** What some samples, by their places, add to the equations. */
  equations(places: readonly number[]): Equations {
    const rows = places.map((place) => this.#rows[place] as Float64Array);
    const size = this.supports.length;
    const right = this.ways.map((values) => {
      const sum = new Float64Array(size);
      rows.forEach((row, index) => {
        const value = values[places[index] as number] as number;
        for (let place = 0; place < size; place++) sum[place] = (sum[place] as number) + (row[place] as number) * value;
      });
      return sum;
    });
    return { left: gram(rows, size), right };
  }

  /** The weights of each output, at a price. */
  solve({ left, right }: Equations, price: number): Float64Array[] {
    const factor = cholesky(plus(left, this.#between, price), LEAST * left.length);
    return right.map((sum) => substitute(factor, sum));
  }

  /** What weights make of a sample, by its place. */
  read(weights: Float64Array, place: number): number {
    return dot(weights, this.#rows[place] as Float64Array);
  }
}

/** Of each output the highest price that foretells nearly as well as any, and how well that is, a correlation. */
function choosePrices(regression: Regression, stretches: readonly number[]): { prices: number[]; foretold: number[] } {
  const { ways } = regression;
  const folds = Array.from({ length: FOLDS }, (_, fold) =>
    [...stretches.keys()].filter((place) => (stretches[place] ?? 0) % FOLDS === fold),
  );
  const parts = folds.map((places) => regression.equations(places));
  const whole = parts.reduce((sum, part) => combine(sum, part, 1));
  const tried = PRICES.map((price) => {
    const found = ways.map((values) => new Float64Array(values.length));
    folds.forEach((places, fold) => {
      const weights = regression.solve(combine(whole, parts[fold] as Equations, -1), price);
      found.forEach((values, output) => {
        for (const place of places) values[place] = regression.read(weights[output] as Float64Array, place);
      });
    });
    return found;
  });
  const chosen = ways.map((values, output) => {
    const errors = tried.map((found) => squareOf(found[output] ?? [], values));
    return errors.findLastIndex((error) => error <= (1 + SLACK) * Math.min(...errors));
  });
  return {
    prices: chosen.map((place) => PRICES[place] ?? 1),
    foretold: chosen.map((place, output) => correlation(ways[output] ?? [], tried[place]?.[output] ?? [])),
  };
}

const combine = (first: Equations, second: Equations, share: number): Equations => ({
  left: plus(first.left, second.left, share),
  right: plus(first.right, second.right, share),
});

const plus = (first: readonly Float64Array[], second: readonly Float64Array[], share: number): Float64Array[] =>
  first.map((row, line) => row.map((value, place) => value + share * (second[line]?.[place] ?? 0)));

/** A value as it is kept as text. */
const rounded = (value: number): number => Math.round(1000 * value) / 1000 || 0;

const squareOf = (first: ArrayLike<number>, second: ArrayLike<number>): number =>
  dot(first, first) + dot(second, second) - 2 * dot(first, second);
