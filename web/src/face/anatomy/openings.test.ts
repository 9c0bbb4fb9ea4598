import { describe, expect, it } from "vitest";
import { opening, outline } from "./openings";

const COUNT = 30;
/** A flat ellipse, walked counter-clockwise from its left end. */
const ellipse = new Float32Array(
  Array.from({ length: COUNT }, (_, n) => (2 * Math.PI * n) / COUNT).flatMap((turn) => [
    3 * Math.cos(turn),
    Math.sin(turn),
    0,
  ]),
);
const rows = Array.from({ length: COUNT }, (_, n) => n);
const x = (row: number) => ellipse[3 * row] as number;
const y = (row: number) => ellipse[3 * row + 1] as number;

describe("the edges of an opening", () => {
  it("run from corner to corner, the upper one above the lower one", () => {
    const { upper, lower } = opening(rows, ellipse, 8);
    for (const edge of [upper, lower]) {
      expect(edge).toHaveLength(8);
      expect(x(edge[0] as number)).toBeCloseTo(-3);
      expect(x(edge[7] as number)).toBeCloseTo(3);
      for (let n = 1; n < 8; n++) expect(x(edge[n] as number)).toBeGreaterThan(x(edge[n - 1] as number));
    }
    expect(upper.slice(1, -1).every((row) => y(row) > 0)).toBe(true);
    expect(lower.slice(1, -1).every((row) => y(row) < 0)).toBe(true);
  });

  it("are the same wherever the line begins and whichever way it is walked", () => {
    const turned = [...rows.slice(11), ...rows.slice(0, 11)];
    const expected = opening(rows, ellipse);
    expect(opening(turned, ellipse)).toEqual(expected);
    expect(opening([...turned].reverse(), ellipse)).toEqual(expected);
  });

  it("can be had of anything that has no line: from its outermost rows", () => {
    const line = outline(rows, ellipse);
    const { upper, lower } = opening(line, ellipse, 3);
    expect(upper.map(y)[1]).toBe(Math.max(...rows.map(y)));
    expect(lower.map(y)[1]).toBe(Math.min(...rows.map(y)));
    expect([upper[0], upper[2]]).toEqual([lower[0], lower[2]]);
  });

  it("repeat rows where a line has few", () => {
    const { upper } = opening([0, 7, 15, 22], ellipse, 6);
    expect(upper).toEqual([15, 15, 7, 7, 0, 0]);
  });
});
