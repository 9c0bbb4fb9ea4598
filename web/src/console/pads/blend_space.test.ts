import { describe, expect, it } from "vitest";
import { softBands } from "./blend_space";

const SQUARE = [
  [0, 0],
  [0.8, 0.1],
  [-0.5, 0.7],
  [-0.3, -0.9],
];
const sum = (numbers: readonly number[]): number => numbers.reduce((total, number) => total + number, 0);

// What Python gives at any point is asked in tests/browser/test_pads.py.
describe("the weights of looks", () => {
  it("are one at a look, and its alone", () => {
    for (const [at, place] of SQUARE.entries())
      expect(softBands(SQUARE, place)).toEqual(SQUARE.map((_, other) => (other === at ? 1 : 0)));
  });

  it("are parts of one everywhere", () => {
    for (let x = -1.25; x <= 1.25; x += 0.25)
      for (let y = -1.25; y <= 1.25; y += 0.25) {
        const weights = softBands(SQUARE, [x, y]);
        expect(Math.min(...weights)).toBeGreaterThanOrEqual(0);
        expect(sum(weights)).toBeCloseTo(1, 12);
      }
  });

  it("are halves between two, and leave out what lies behind another", () => {
    expect(softBands([[-1], [0]], [-0.5])).toEqual([0.5, 0.5]);
    expect(softBands([[-1], [0], [1]], [-0.5])[2]).toBe(0);
  });
});
