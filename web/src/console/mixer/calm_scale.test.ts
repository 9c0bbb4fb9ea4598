import { describe, expect, test } from "vitest";
import { livelinessOf, secondsOf, smoothingWords } from "./calm_scale";

describe("calm to lively", () => {
  test("seconds come back as they were, and shrink from calm to lively", () => {
    const seconds = [0, 0.2, 0.4, 0.6, 0.8, 1].map(secondsOf);
    expect(seconds.map(livelinessOf).map((at) => Math.round(100 * at))).toEqual([0, 20, 40, 60, 80, 100]);
    expect(seconds).toEqual(seconds.toSorted((duration, other) => other - duration));
    expect([seconds[0], seconds.at(-1)]).toEqual([2, 0.03]);
  });

  test("what is not set stands between both, and is told as usual", () => {
    expect(secondsOf(null)).toBe(0);
    expect(livelinessOf(0)).toBeGreaterThan(0.5);
    expect([smoothingWords(0), smoothingWords(0.25)]).toEqual(["usual", "0.25 s"]);
  });

  test("seconds beyond the ends stand at them", () => {
    expect([livelinessOf(9), livelinessOf(0.001)]).toEqual([0, 1]);
  });
});
