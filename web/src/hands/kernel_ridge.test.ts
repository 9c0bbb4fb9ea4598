import { expect, it } from "vitest";
import { applyKernel, fitKernel } from "./kernel_ridge";
import { correlation } from "./ridge";
import { seededNumbers } from "./synthetic_hand";

const random = seededNumbers(4);
const draw = (count: number): number[][] =>
  Array.from({ length: count }, () => Array.from({ length: 4 }, () => 2 * random() - 1));
const samples = draw(300);
const stretches = samples.map((_, place) => Math.floor(place / 10));
const others = draw(100);
/** What no straight map tells: the second number counts by the sign of the first. */
const bent = ([a = 0, b = 0]: number[]): number => a * b;
const straight = ([a = 0, , c = 0]: number[]): number => 2 * a - c + 3;

const readings = (map: Parameters<typeof applyKernel>[0], rows: number[][], output: number): number[] =>
  rows.map((row) => applyKernel(map, row)[output] ?? 0);

it("finds what is straight and what bends, and foretells how well it will", () => {
  const { map, foretold } = fitKernel(samples, stretches, [samples.map(straight), samples.map(bent)]);
  [straight, bent].forEach((truth, output) => {
    const fits = correlation(readings(map, others, output), others.map(truth));
    expect(fits).toBeGreaterThan(0.97);
    expect(Math.abs(fits - (foretold[output] ?? 0))).toBeLessThan(0.02);
  });
});

it("goes on straight where there were no samples", () => {
  const { map } = fitKernel(samples, stretches, [samples.map(straight)]);
  const far = [5, 0, 5, 0];
  expect(applyKernel(map, far)[0]).toBeCloseTo(straight(far), 0);
});

it("foretells nothing of what the numbers do not tell, and then reads little more than its mean", () => {
  const noise = samples.map(() => random());
  const { map, foretold } = fitKernel(samples, stretches, [noise]);
  expect(Math.abs(foretold[0] ?? 1)).toBeLessThan(0.25);
  for (const value of readings(map, others, 0)) expect(Math.abs(value - 0.5)).toBeLessThan(0.3);
});

it("pays a higher price for weights where what was asked was not quite done", () => {
  const size = (shake: number): number => {
    const wanted = samples.map((sample) => bent(sample) + shake * (random() - 0.5));
    return Math.hypot(...(fitKernel(samples, stretches, [wanted]).map.weights[0] ?? []));
  };
  expect(size(3)).toBeLessThan(size(0));
});

it("bears samples that are all alike, numbers that never vary, and more samples than it keeps", () => {
  const alike = Array.from({ length: 500 }, (_, place) => [1, place % 2, 7]);
  const { map } = fitKernel(
    alike,
    alike.map((_, place) => place),
    [alike.map(([, value = 0]) => value)],
  );
  expect(map.supports.length).toBeLessThan(alike.length);
  expect(applyKernel(map, [1, 1, 7])[0]).toBeCloseTo(1, 1);
  expect(applyKernel(map, [1, 0, 7])[0]).toBeCloseTo(0, 1);
});
