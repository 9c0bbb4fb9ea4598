import { describe, expect, it } from "vitest";
import { wholeColumns } from "./edge_smoothing";

describe("the columns that are smoothed", () => {
  it("hold the part that was asked for and lie in the canvas", () => {
    for (const width of [1, 15, 100, 400, 1281])
      for (const [from, to] of [
        [0, 1],
        [0.21, 0.8],
        [0.5, 0.5],
        [0.99, 1],
      ] as const) {
        const [first, end] = wholeColumns([from, to], width);
        expect(first).toBeGreaterThanOrEqual(0);
        expect(first).toBeLessThanOrEqual(from * width);
        expect(end).toBeGreaterThanOrEqual(to * width);
        expect(end).toBeLessThanOrEqual(width);
      }
  });

  it("stay the same while a head moves by a little", () => {
    expect(wholeColumns([0.3, 0.7], 1000)).toEqual(wholeColumns([0.302, 0.698], 1000));
  });
});
