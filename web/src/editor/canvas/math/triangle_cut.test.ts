import { describe, expect, it } from "vitest";
import { type Box, contains, expanded } from "./boxes";
import { Camera, FIRST_VIEW } from "./camera";
import { cut, type Surface } from "./triangle_cut";
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
const SURFACE = { rows: Uint16Array.from({ length: SIDE * SIDE }, (_, n) => n), width: 1, triangles: TRIANGLES };
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
  const all = { left: -1e4, top: -1e4, width: 2e4, height: 2e4 };
  const places = CAMERA.projectAll(POINTS);
  const kept = (surface: Surface, box: Box, slack: number): Uint32Array => {
    const list = new Uint32Array(surface.triangles.length);
    return list.slice(0, cut(surface, places, box, slack, list));
  };
  const named = (list: Uint32Array) =>
    new Set(Array.from({ length: list.length / 3 }, (_, n) => list.slice(3 * n, 3 * n + 3).join()));

  it("keeps every triangle with a corner in the box, and drops most of the others", () => {
    const few = kept(SURFACE, small, 0);
    const inside = (row: number) => {
      const [across, down] = CAMERA.project(point(row));
      return contains(small, { left: across, top: down, width: 0, height: 0 });
    };
    for (let at = 0; at < TRIANGLES.length; at += 3) {
      const corners = TRIANGLES.slice(at, at + 3);
      if (corners.some(inside)) expect(named(few)).toContain(corners.join());
    }
    expect(few.length).toBeLessThan(TRIANGLES.length / 3);
  });

  it("keeps more when rows may move, and all in a box that holds all", () => {
    expect(kept(SURFACE, small, 20).length).toBeGreaterThan(kept(SURFACE, small, 0).length);
    expect([...kept(SURFACE, all, 0)]).toEqual([...TRIANGLES]);
  });

  it("keeps a triangle whose corners lie between rows around the box", () => {
    const between = { rows: [0, 8, 72, 0, 8, 72, 0, 8, 72], width: 3, triangles: [0, 1, 2] };
    expect([...kept(between, small, 0)]).toEqual([0, 1, 2]);
    expect(kept(between, { ...small, left: -500 }, 0)).toHaveLength(0);
  });

  it("reaches ahead of what was asked for", () => {
    expect(contains(expanded(small), small)).toBe(true);
    expect(contains(small, expanded(small))).toBe(false);
  });
});
