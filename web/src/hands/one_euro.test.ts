import { expect, it } from "vitest";
import { OneEuroFilter } from "./one_euro";
import { seededNumbers } from "./synthetic_hand";

it("holds still what trembles, and follows what moves", () => {
  const filter = new OneEuroFilter();
  const random = seededNumbers(4);
  let shaking = 0;
  for (let count = 0; count < 200; count++) {
    const [value = 0] = filter.follow([0.04 * (random() - 0.5)], count / 20);
    if (count > 20) shaking = Math.max(shaking, Math.abs(value));
  }
  expect(shaking).toBeLessThan(0.015);
  const [, second = 0] = [filter.follow([1], 10), filter.follow([1], 10.05)[0]];
  expect(second).toBeGreaterThan(0.8);
});

it.each([7, 10, 15, 20, 30])("leaves .85 of an opening as fast as speech, by %i pictures a second", (rate) => {
  const [filter, random] = [new OneEuroFilter(), seededNumbers(5)];
  const wave = [0, 0];
  const count = 40 * rate;
  for (let picture = 0; picture < count; picture++) {
    const time = (picture + 0.4 * random()) / rate;
    const turn = 2 * Math.PI * 4 * time;
    const [value = 0] = filter.follow([0.5 + 0.35 * Math.sin(turn)], time);
    wave[0] = (wave[0] ?? 0) + ((value - 0.5) * Math.sin(turn) * 2) / count;
    wave[1] = (wave[1] ?? 0) + ((value - 0.5) * Math.cos(turn) * 2) / count;
  }
  expect(Math.hypot(...wave) / 0.35).toBeGreaterThan(0.85);
});

it("begins anew after a gap, and where the clock jumps", () => {
  const filter = new OneEuroFilter();
  filter.follow([0], 1);
  expect(filter.follow([1], 3)).toEqual([1]);
  expect(filter.follow([0.5], 2)).toEqual([0.5]);
});
