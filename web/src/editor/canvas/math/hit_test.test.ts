import { describe, expect, it } from "vitest";
import { patch } from "../model/skin_patch";
import { filled, hit, nearestCorner } from "./hit_test";
import { cross, minus, rowOf, type Triple } from "./vectors";

describe("hit", () => {
  const { positions, triangles } = patch();

  it("finds where a ray meets the skin, on the triangle's plane", () => {
    const met = hit(positions, triangles, [0.011, 0.013, 1], [0, 0, -1]);
    expect(met?.point.slice(0, 2)).toEqual([0.011, 0.013]);
    expect(met?.point[2]).toBeGreaterThan(0.098);
    expect(met?.point[2]).toBeLessThan(0.1);
    expect(met?.distance).toBeCloseTo(1 - (met?.point[2] as number), 9);
  });

  it("passes skin that is seen from behind, and what is not there", () => {
    expect(hit(positions, triangles, [0.011, 0.013, -1], [0, 0, 1])).toBeUndefined();
    expect(hit(positions, triangles, [0.5, 0, 1], [0, 0, -1])).toBeUndefined();
  });

  it("names the nearest welcome corner", () => {
    const met = hit(positions, triangles, [0.0005, 0.0004, 1], [0, 0, -1]);
    expect(met && nearestCorner(met, positions, () => true)).toBe(40);
    expect(met && nearestCorner(met, positions, (row) => row !== 40)).not.toBe(40);
    expect(met && nearestCorner(met, positions, () => false)).toBeUndefined();
  });
});

it("fills a loop with triangles that face outward and cover it", () => {
  const corners = Array.from({ length: 12 }, (_, n) => [2 * Math.cos(n / 1.91), Math.sin(n / 1.91), 0]);
  const positions = Float32Array.from(corners.flat());
  const loop = corners.map((_, n) => n);
  const areaOf = (list: readonly number[], sign: number) => {
    let sum = 0;
    for (let at = 0; at < list.length; at += 3) {
      const [a, b, c] = [0, 1, 2].map((n) => rowOf(positions, list[at + n] as number)) as [Triple, Triple, Triple];
      const twice = cross(minus(b, a), minus(c, a))[2];
      expect(sign * twice).toBeGreaterThanOrEqual(0);
      sum += Math.abs(twice) / 2;
    }
    return sum;
  };
  let shoelace = 0;
  for (let n = 0; n < 12; n++) {
    const [a, b] = [corners[n] as number[], corners[(n + 1) % 12] as number[]];
    shoelace += ((a[0] as number) * (b[1] as number) - (b[0] as number) * (a[1] as number)) / 2;
  }
  for (const sign of [1, -1]) {
    const list = filled(loop, positions, [0, 0, sign]);
    expect(list).toHaveLength(30);
    expect(areaOf(list, sign)).toBeCloseTo(shoelace, 5);
  }
});
