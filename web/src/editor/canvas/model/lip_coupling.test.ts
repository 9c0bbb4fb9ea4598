import { describe, expect, it } from "vitest";
import { halves, type Lips, together } from "./lip_coupling";

/** A mouth 8 cm wide of 9 columns: upper edge at rows 0..8, lower one at rows 9..15, `gap` metres below it; rows 0 and 8
 * are the corners. */
function mouth(gap = 0): { positions: Float32Array; line: Uint32Array; lips: Lips } {
  const positions = new Float32Array(3 * 16);
  for (let column = 0; column < 9; column++) positions.set([(column - 4) / 100, 0, 0], 3 * column);
  for (let column = 1; column < 8; column++) positions.set([(column - 4) / 100, -gap, 0], 3 * (8 + column));
  const line = Uint32Array.from([2, 3, 4, 5, 6, 7, 8, 15, 14, 13, 12, 11, 10, 9, 0, 1]);
  return { positions, line, lips: halves(line, positions) as Lips };
}

/** Distances along the edges from a row, around the corners. */
function around(lips: Lips, positions: Float32Array, from: number): Float32Array {
  const loop = [...lips[0].rows, ...[...lips[1].rows].slice(1, -1).reverse()];
  const steps = loop.map((row, at) => {
    const next = loop[(at + 1) % loop.length] as number;
    return Math.hypot(
      ...[0, 1, 2].map((k) => (positions[3 * row + k] as number) - (positions[3 * next + k] as number)),
    );
  });
  const far = new Float32Array(16).fill(Infinity);
  const whole = steps.reduce((sum, step) => sum + step, 0);
  let gone = 0;
  for (let at = 0; at < loop.length; at++) {
    const place = (loop.indexOf(from) + at) % loop.length;
    far[loop[place] as number] = Math.min(gone, whole - gone);
    gone += steps[place] as number;
  }
  return far;
}

const pairs = [1, 2, 3, 4, 5, 6, 7].map((column) => [column, 8 + column] as const);

describe("halves", () => {
  it("go from the same corner to the other, whatever way the line walks", () => {
    const { positions, line } = mouth();
    for (const walked of [line, line.slice().reverse()]) {
      const lips = halves(walked, positions) as Lips;
      const edges = lips.map(({ rows }) => [...rows]).sort((a, b) => (a[1] as number) - (b[1] as number));
      expect(edges).toEqual([
        [0, 1, 2, 3, 4, 5, 6, 7, 8],
        [0, 9, 10, 11, 12, 13, 14, 15, 8],
      ]);
      for (const { shares } of lips) for (const [at, share] of shares.entries()) expect(share).toBeCloseTo(at / 8, 6);
    }
    expect(halves(undefined, positions)).toBeNull();
  });
});

describe("lips that meet", () => {
  it("are as near on both sides to what is dragged at a corner", () => {
    const { positions, lips } = mouth();
    for (const row of [8, 7, 15]) {
      const far = around(lips, positions, row);
      together(lips, far, positions);
      for (const [upper, lower] of pairs) expect(far[upper]).toBeCloseTo(far[lower] as number, 6);
      expect(far[row]).toBe(0);
    }
  });

  it("stay as they are when the middle of one is dragged", () => {
    const { positions, lips } = mouth();
    const far = around(lips, positions, 4);
    const before = far.slice();
    together(lips, far, positions);
    expect(far).toEqual(before);
  });

  it("go apart once they are open", () => {
    const { positions, lips } = mouth(0.03);
    const far = around(lips, positions, 7);
    const before = far.slice();
    together(lips, far, positions);
    expect((before[15] as number) - (far[15] as number)).toBeLessThan(0.02);
    expect(far[15]).toBeGreaterThanOrEqual(0.03 - 0.13 * 0.08 - 1e-6);
  });

  it("are never farther than along the skin", () => {
    const { positions, lips } = mouth(0.004);
    for (let row = 0; row < 16; row++) {
      const far = around(lips, positions, row);
      const before = far.slice();
      together(lips, far, positions);
      for (const [at, value] of far.entries()) expect(value).toBeLessThanOrEqual((before[at] as number) + 1e-7);
    }
  });
});
