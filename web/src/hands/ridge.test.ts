import { expect, it } from "vitest";
import { applyRidge, correlation, RidgeFit } from "./ridge";
import { seededNumbers } from "./synthetic_hand";

const random = seededNumbers(3);
const samples = Array.from({ length: 200 }, () => Array.from({ length: 8 }, () => random()));

it("finds a linear map, its offset too", () => {
  const wanted = samples.map(([a = 0, b = 0, , , e = 0]) => 2 * a - b + 0.5 * e + 3);
  const map = new RidgeFit(samples, 1e-9).solve([wanted, wanted.map((value) => -value)]);
  samples.forEach((sample, place) => {
    expect(applyRidge(map, sample)[0]).toBeCloseTo(wanted[place] ?? 0, 4);
    expect(applyRidge(map, sample)[1]).toBeCloseTo(-(wanted[place] ?? 0), 4);
  });
});

it("shrinks towards the mean, and is not upset by what never varies or is said twice", () => {
  const twice = samples.map((sample) => [...sample, 7, sample[0] ?? 0]);
  const wanted = samples.map(([a = 0]) => a);
  const size = (shrink: number): number =>
    Math.hypot(...(new RidgeFit(twice, shrink).solve([wanted]).weights[0] ?? []));
  expect(size(10)).toBeLessThan(size(0.01));
  expect(new RidgeFit(twice, 0.01).solve([wanted]).weights[0]?.[8]).toBe(0);
  const strong = new RidgeFit(twice, 1e9).solve([wanted]);
  const middle = wanted.reduce((sum, value) => sum + value, 0) / wanted.length;
  expect(applyRidge(strong, twice[0] ?? [])[0]).toBeCloseTo(middle, 3);
});

it("correlates", () => {
  expect(correlation([1, 2, 3], [2, 4, 6])).toBeCloseTo(1);
  expect(correlation([1, 2, 3], [3, 2, 1])).toBeCloseTo(-1);
  expect(correlation([1, 1, 1], [3, 2, 1])).toBe(0);
});
