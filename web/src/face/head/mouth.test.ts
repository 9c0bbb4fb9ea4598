import { describe, expect, it } from "vitest";
import { places } from "./mouth";

/** An arch of nine columns of a gum's and an edge's vertex, the edge 10 mm below, each column lower than the one before. */
const columns = Array.from({ length: 9 }, (_, n) => (n - 4) * 0.25);
const positions = new Float32Array(
  columns.flatMap((angle, n) =>
    [0, -0.01].flatMap((y) => [0.034 * Math.sin(angle), y - 0.001 * n, 0.034 * Math.cos(angle)]),
  ),
);
const mesh = (name: string) => ({
  name,
  source: Uint32Array.from({ length: 18 }, (_, row) => row),
  uv: new Float32Array(36),
  triangles: new Uint32Array(),
  openness: new Uint8Array(18),
});
const column = (values: Float32Array, part: number) => Array.from({ length: 18 }, (_, row) => values[4 * row + part]);

describe("the places on teeth", () => {
  const upper = places(mesh("teeth_upper"), positions);

  it("go from the gum to the edge of each column, however the arch slopes", () => {
    expect(column(upper, 2)).toEqual(columns.flatMap(() => [0, 1]));
    const lower = places(mesh("teeth_lower"), positions);
    expect(column(lower, 2)).toEqual(columns.flatMap(() => [1, 0]));
  });

  it("count angles along the arch from the middle, + to the left", () => {
    column(upper, 1).forEach((angle, row) => {
      expect(angle).toBeCloseTo(columns[row >> 1] as number);
    });
  });

  it("know the jaw and the depth", () => {
    expect(new Set(column(upper, 3))).toEqual(new Set([1]));
    expect(upper[4 * 8]).toBeCloseTo(0);
    expect(Math.max(...(column(upper, 0) as number[]))).toBeCloseTo((0.034 * (1 - Math.cos(1))) / 0.05);
  });
});
