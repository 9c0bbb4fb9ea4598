import { expect, test } from "vitest";
import { Warp } from "./warp";

/** A sequence that looks random and is the same each time. */
function numbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state * 16807) % 2147483647;
    return state / 2147483647 - 0.5;
  };
}

const next = numbers(7);
const POINTS = Float64Array.from({ length: 3 * 24 }, () => 0.2 * next());
const PLACES = Float64Array.from({ length: 3 * 40 }, () => 0.3 * next());
const warp = new Warp(POINTS);

const displaced = (where: ArrayLike<number>, moves: ArrayLike<number>): Float32Array => {
  const out = new Float32Array(where.length);
  warp.add(out, where, moves);
  return out;
};

const near = (values: ArrayLike<number>, wanted: ArrayLike<number>, digits = 6): void => {
  expect(values.length).toBe(wanted.length);
  for (let at = 0; at < values.length; at++) expect(values[at]).toBeCloseTo(wanted[at] as number, digits);
};

test("points arrive where they are moved to", () => {
  const moves = Float64Array.from(POINTS, () => 0.02 * next());
  near(displaced(POINTS, moves), moves);
});

test("an affine motion of the points is that motion everywhere", () => {
  const motion = (points: Float64Array): Float64Array =>
    points.map((_, at) => {
      const [x, y, z] = [0, 1, 2].map((axis) => points[at - (at % 3) + axis] as number) as [number, number, number];
      return [0.01 + 0.1 * x, 0.2 * z - 0.05 * y, -0.02 + 0.3 * y][at % 3] as number;
    });
  near(displaced(PLACES, motion(POINTS)), motion(PLACES));
});

test("each place follows each point by its share, and all shares sum to one", () => {
  const moves = Float64Array.from(POINTS, () => 0.02 * next());
  const sum = new Float64Array(PLACES.length);
  const shares = new Float64Array(PLACES.length / 3);
  for (let place = 0; 3 * place < POINTS.length; place++)
    warp.follows(PLACES, place).forEach((share, row) => {
      shares[row] = (shares[row] as number) + share;
      for (let axis = 0; axis < 3; axis++)
        sum[3 * row + axis] = (sum[3 * row + axis] as number) + share * (moves[3 * place + axis] as number);
    });
  near(sum, displaced(PLACES, moves));
  near(
    shares,
    shares.map(() => 1),
  );
});

test("points in one plane are refused with a sentence", () => {
  expect(() => new Warp(POINTS.map((value, at) => (at % 3 === 1 ? 0 : value)))).toThrow("lie in one plane");
});
