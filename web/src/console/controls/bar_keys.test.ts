import { describe, expect, it } from "vitest";
import { BarKeys } from "./bar_keys";

/** Where steps lead, one after another. */
function walk(keys: BarKeys, flipped: boolean, from: number, steps: readonly number[], target: string | null = "cat") {
  return steps.reduce((position, by) => keys.step({ target, flipped }, position, by), from);
}
const times = (count: number, by: number): number[] => Array<number>(count).fill(by);

describe("keys on a T-bar", () => {
  it("move a call on from the end that it begins at, whichever key is pressed", () => {
    for (const by of [0.25, -0.25])
      for (const [start, flipped] of [
        [0, false],
        [1, true],
      ] as const)
        expect(walk(new BarKeys(), flipped, start, times(4, by))).toBe(1 - start);
  });

  it("lead back by the other key", () => {
    expect(walk(new BarKeys(), true, 1, [0.25, 0.25, -0.25])).toBe(0.75);
  });

  it("never lead back from the end that a call goes to", () => {
    expect(walk(new BarKeys(), true, 1, times(9, 0.25))).toBe(0);
    expect(walk(new BarKeys(), false, 0, times(9, 0.25))).toBe(1);
  });

  it("mean up and down again at the next call, and where nothing is called", () => {
    const keys = new BarKeys();
    walk(keys, true, 1, [0.25]);
    expect(walk(keys, false, 0.5, [0.25], "dog")).toBe(0.75);
    walk(keys, true, 1, [0.25]);
    expect(walk(keys, false, 0.5, [0.25], null)).toBe(0.75);
    expect(walk(keys, false, 1, [0.25], null)).toBe(1);
  });
});
