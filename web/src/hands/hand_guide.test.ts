import { expect, it } from "vitest";
import { GUIDE_SECONDS, GUIDE_SECTIONS, guideSection, guideTargets, HAND_AXES, REST_SECONDS } from "./hand_guide";

it("takes about a minute, and tells in words what is to be done", () => {
  expect(GUIDE_SECONDS).toBeGreaterThan(50);
  expect(GUIDE_SECONDS).toBeLessThan(65);
  for (const { name, advice } of GUIDE_SECTIONS) expect(advice).not.toBe(name);
  expect(guideSection(0).name).toBe("rest");
  expect(guideSection(1e9)).toBe(GUIDE_SECTIONS.at(-1));
});

it("moves every axis both ways, without a jump, from rest to rest", () => {
  const range = Object.fromEntries(HAND_AXES.map((axis) => [axis, [0, 0]])) as Record<string, number[]>;
  let before = guideTargets(0);
  for (let time = 0; time <= GUIDE_SECONDS + 1; time += 0.02) {
    const now = guideTargets(time);
    for (const axis of HAND_AXES) {
      expect(Math.abs(now[axis] - before[axis])).toBeLessThan(0.15);
      range[axis] = [Math.min(range[axis]?.[0] ?? 0, now[axis]), Math.max(range[axis]?.[1] ?? 0, now[axis])];
    }
    if (time < REST_SECONDS || time > GUIDE_SECONDS) for (const axis of HAND_AXES) expect(now[axis]).toBeCloseTo(0);
    before = now;
  }
  for (const axis of HAND_AXES) {
    expect(range[axis]?.[1]).toBeGreaterThan(0.7);
    expect(range[axis]?.[0]).toBeCloseTo(axis === "opening" ? 0 : -0.85, axis === "opening" ? 5 : 0);
  }
});

it("has every two axes meet both ways, for two seconds each, no faster than a person follows", () => {
  const step = 0.02;
  const moments = Array.from({ length: GUIDE_SECONDS / step }, (_, place) => guideTargets(step * place));
  const ways = moments.map(({ opening, ...rest }) => ({ ...rest, opening: 2 * opening - 1 }));
  HAND_AXES.forEach((first, place) => {
    for (const second of HAND_AXES.slice(place + 1)) {
      for (const [a, b] of [
        [1, 1],
        [1, -1],
        [-1, 1],
        [-1, -1],
      ] as const) {
        const met = ways.filter((way) => a * way[first] > 0.3 && b * way[second] > 0.3).length * step;
        expect([first, second, a, b, met > 2]).toEqual([first, second, a, b, true]);
      }
    }
  });
  for (const axis of HAND_AXES.slice(1)) {
    const speeds = moments.slice(1).map((moment, at) => Math.abs(moment[axis] - (moments[at]?.[axis] ?? 0)) / step);
    expect(Math.max(...speeds)).toBeLessThan(4);
  }
});
