import { describe, expect, it } from "vitest";
import { BROW_LINE, BROW_REACH } from "../../link/constants";
import { browHair, skinPlaces } from "./brows";

const HAIRS = Array.from({ length: 420 }, (_, n) => browHair(n, 1));

describe("a brow", () => {
  it("grows along its line, from nose to temple", () => {
    const [inner, outer] = BROW_REACH;
    for (const { root } of HAIRS) {
      expect(root[0]).toBeGreaterThanOrEqual(inner);
      expect(root[0]).toBeLessThanOrEqual(outer);
      expect(Math.abs(root[1] - 0.02)).toBeLessThan(0.01);
    }
    expect(BROW_LINE[0][0]).toBeLessThanOrEqual(inner);
  });

  it("stands up near the nose, and lies outwards at the temple", () => {
    const steepness = (hairs: typeof HAIRS): number =>
      hairs.reduce((sum, { root, tip }) => sum + Math.atan2(tip[1] - root[1], tip[0] - root[0]), 0) / hairs.length;
    expect(steepness(HAIRS.slice(0, 40))).toBeGreaterThan(steepness(HAIRS.slice(-40)) + 0.3);
    for (const { root, tip } of HAIRS) expect(tip[0]).toBeGreaterThan(root[0] - 0.001);
  });

  it("is strongest in its middle: what is far from the line shows on bushy brows alone", () => {
    const far = HAIRS.filter(({ strength }) => strength < 0.4);
    expect(far.length).toBeGreaterThan(20);
    for (const { strength } of HAIRS) {
      expect(strength).toBeGreaterThan(0);
      expect(strength).toBeLessThanOrEqual(1);
    }
  });
});

describe("a place on the skin", () => {
  /** Two sheets one behind the other, and one that faces back. */
  const positions = Float32Array.from(
    [
      [-1, -1, 0.1],
      [1, -1, 0.1],
      [0, 1, 0.1],
      [-1, -1, 0.2],
      [1, -1, 0.2],
      [0, 1, 0.2],
      [-1, -1, 0.3],
      [0, 1, 0.3],
      [1, -1, 0.3],
    ].flatMap(([x = 0, y = 0, z = 0]) => [0.02 * x, 0.02 + 0.02 * y, z]),
  );
  const find = skinPlaces([0, 1, 2, 3, 4, 5, 6, 7, 8], positions);

  it("lies on the foremost triangle that faces ahead, by shares that sum to one", () => {
    const place = find(0.003, 0.015);
    expect(place?.rows).toEqual([3, 4, 5]);
    expect(place?.shares.reduce((sum, share) => sum + share, 0)).toBeCloseTo(1);
    const at = [0, 1].map((axis) =>
      (place?.rows ?? []).reduce(
        (sum, row, n) => sum + (place?.shares[n] ?? 0) * (positions[3 * row + axis] as number),
        0,
      ),
    );
    expect(at[0]).toBeCloseTo(0.003);
    expect(at[1]).toBeCloseTo(0.015);
  });

  it("is nowhere beside the skin", () => {
    expect(find(0.03, 0.02)).toBeUndefined();
  });
});
