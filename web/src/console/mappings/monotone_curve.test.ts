import { describe, expect, it } from "vitest";
import { curveAt, type Knots, pathOf, STRAIGHT, slopesAt } from "./monotone_curve";

const BENT: Knots = [
  [0, 0],
  [0.3, 0.7],
  [0.5, 0.72],
  [1, 0.1],
];

/** A place on a cubic of Bézier. */
const bezier = (points: readonly number[], part: number): number => {
  const [a, b, c, d] = points as [number, number, number, number];
  const left = 1 - part;
  return left ** 3 * a + 3 * left ** 2 * part * b + 3 * left * part ** 2 * c + part ** 3 * d;
};

describe("curve of a target", () => {
  it("goes through its knots, and never beyond two neighbours", () => {
    for (const [at, gives] of BENT) expect(curveAt(BENT, at)).toBeCloseTo(gives, 12);
    for (const [piece, [begin, low]] of BENT.slice(0, -1).entries()) {
      const [end, high] = BENT[piece + 1] as [number, number];
      for (let part = 0; part <= 1; part += 0.05) {
        const gives = curveAt(BENT, begin + part * (end - begin));
        expect(gives).toBeGreaterThanOrEqual(Math.min(low, high));
        expect(gives).toBeLessThanOrEqual(Math.max(low, high));
      }
    }
  });

  it("is what is drawn", () => {
    const numbers =
      pathOf(BENT, (at, gives) => [at, gives])
        .match(/-?[\d.]+(e-?\d+)?/g)
        ?.map(Number) ?? [];
    const points = numbers.reduce<number[][]>((rows, value, at) => {
      if (at % 2 === 0) rows.push([value]);
      else rows.at(-1)?.push(value);
      return rows;
    }, []);
    for (let piece = 0; piece < BENT.length - 1; piece += 1) {
      const four = points.slice(3 * piece, 3 * piece + 4);
      for (const part of [0.2, 0.5, 0.9]) {
        const [at, gives] = [0, 1].map((axis) =>
          bezier(
            four.map((point) => point[axis] as number),
            part,
          ),
        );
        expect(curveAt(BENT, at as number)).toBeCloseTo(gives as number, 3);
      }
    }
  });

  it("is straight where nobody has bent it, and flat at a peak", () => {
    expect(curveAt(STRAIGHT, 0.37)).toBeCloseTo(0.37, 12);
    const peak: Knots = [
      [0, 0],
      [0.5, 1],
      [1, 0],
    ];
    expect(slopesAt(peak)[1]).toBe(0);
  });
});
