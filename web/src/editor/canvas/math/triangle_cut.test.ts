import { describe, expect, it } from "vitest";
import { contains, expanded } from "./boxes";
import { Camera, FIRST_VIEW } from "./camera";
import { cut } from "./triangle_cut";
import type { Triple } from "./vectors";

const TILE = { left: 20, top: 10, width: 200, height: 200 };
const CAMERA = new Camera(FIRST_VIEW, TILE, { centre: [0, 0, 0], radius: 0.13 });
const SIDE = 9;
/** A sheet of points before the camera, and its triangles. */
const POINTS = Float32Array.from(
  Array.from({ length: SIDE * SIDE }, (_, n) => [
    ((n % SIDE) - 4) * 0.02,
    (Math.floor(n / SIDE) - 4) * 0.02,
    0.05,
  ]).flat(),
);
const TRIANGLES = Uint16Array.from(
  Array.from({ length: (SIDE - 1) * (SIDE - 1) }, (_, n) => {
    const corner = (n % (SIDE - 1)) + SIDE * Math.floor(n / (SIDE - 1));
    return [corner, corner + 1, corner + SIDE, corner + 1, corner + SIDE + 1, corner + SIDE];
  }).flat(),
);
const SURFACE = { rows: Uint16Array.from({ length: SIDE * SIDE }, (_, n) => n), triangles: TRIANGLES };
const point = (row: number): Triple => [0, 1, 2].map((n) => POINTS[3 * row + n] as number) as Triple;

describe("projectAll", () => {
  it("says where project says", () => {
    const all = CAMERA.projectAll(POINTS);
    for (let row = 0; row < SIDE * SIDE; row++) {
      const [x, y] = CAMERA.project(point(row));
      expect(all[2 * row]).toBeCloseTo(x, 3);
      expect(all[2 * row + 1]).toBeCloseTo(y, 3);
    }
  });
});

describe("cut", () => {
  const [x, y] = CAMERA.project(point(40));
  const small = { left: x - 8, top: y - 8, width: 16, height: 16 };

  it("keeps every triangle with a corner in the box, and drops most of the others", () => {
    const kept = cut(SURFACE, CAMERA, POINTS, small, 0);
    const inside = (row: number) => {
      const [across, down] = CAMERA.project(point(row));
      return contains(small, { left: across, top: down, width: 0, height: 0 });
    };
    const named = (list: Uint16Array) =>
      new Set(Array.from({ length: list.length / 3 }, (_, n) => list.slice(3 * n, 3 * n + 3).join()));
    for (let at = 0; at < TRIANGLES.length; at += 3) {
      const corners = TRIANGLES.slice(at, at + 3);
      if (corners.some(inside)) expect(named(kept)).toContain(corners.join());
    }
    expect(kept.length).toBeLessThan(TRIANGLES.length / 3);
  });

  it("keeps more when rows may move, and all in a box that holds all", () => {
    expect(cut(SURFACE, CAMERA, POINTS, small, 0.02).length).toBeGreaterThan(
      cut(SURFACE, CAMERA, POINTS, small, 0).length,
    );
    expect(cut(SURFACE, CAMERA, POINTS, { left: -1e4, top: -1e4, width: 2e4, height: 2e4 }, 0)).toEqual(TRIANGLES);
  });

  it("reaches ahead of what was asked for", () => {
    expect(contains(expanded(small), small)).toBe(true);
    expect(contains(small, expanded(small))).toBe(false);
  });
});
