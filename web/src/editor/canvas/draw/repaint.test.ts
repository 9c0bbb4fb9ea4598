import { describe, expect, it } from "vitest";
import { overlap } from "../math/boxes";
import { Camera, FIRST_VIEW } from "../math/camera";
import type { Triple } from "../math/vectors";
import { boxOf, spreadOf } from "../model/spread";
import { Repaint } from "./repaint";

const TILE = { left: 100, top: 50, width: 300, height: 400 };
const CAMERA = new Camera(FIRST_VIEW, TILE, { centre: [0, 0, 0], radius: 0.13 });
const POINTS = Float32Array.from([0.01, 0.02, 0.1, -0.03, 0.05, 0.08, 0.02, -0.06, 0.09]);

describe("spreadOf", () => {
  const live = POINTS.slice();
  live[3] = (live[3] as number) + 1; // row 1: a metre along x
  live[7] = (live[7] as number) + 0.5;
  const figure = { base: POINTS, live };
  const still = { base: POINTS, live: POINTS };

  it("holds each row where it was and where it is led", () => {
    const { low, high, reach } = spreadOf(figure, Uint32Array.of(1, 2));
    for (const [row, axis, way] of [
      [1, 0, 1],
      [2, 1, 0.5],
    ] as const) {
      const value = POINTS[3 * row + axis] as number;
      expect(low[axis]).toBeLessThanOrEqual(value);
      expect(high[axis]).toBeGreaterThanOrEqual(Math.fround(value + way));
    }
    expect(reach).toBeCloseTo(1);
    expect(spreadOf(figure, Uint32Array.of(2)).reach).toBeCloseTo(0.5);
    expect(spreadOf(still, Uint32Array.of(2)).reach).toBe(0);
  });

  it("is a box on the screen that holds them all, with its border", () => {
    const box = boxOf(CAMERA, spreadOf(still, Uint32Array.of(0, 1, 2)), 0.01);
    for (let row = 0; row < 3; row++)
      for (const way of [0.01, -0.01])
        for (let axis = 0; axis < 3; axis++) {
          const point = [0, 1, 2].map((n) => (POINTS[3 * row + n] as number) + (n === axis ? way : 0)) as Triple;
          const [x, y] = CAMERA.project(point);
          const spot = { left: x, top: y, width: 0, height: 0 };
          expect(overlap(spot, box)).toEqual(spot);
        }
  });

  it("is nothing within a tile when no row moves", () => {
    const { width, height } = overlap(boxOf(CAMERA, spreadOf(figure, new Uint32Array()), 0), TILE);
    expect(width > 0 && height > 0).toBe(false);
  });
});

describe("Repaint", () => {
  it("cuts triangles anew only when a part reaches beyond the last cut", () => {
    const repaint = new Repaint();
    const part = { left: 150, top: 100, width: 100, height: 100 };
    expect(repaint.cover(part, 0.01)).toEqual({ box: { left: 140, top: 90, width: 120, height: 120 }, reach: 0.02 });
    expect(repaint.cover({ ...part, left: 160 }, 0.015)).toBeUndefined();
    expect(repaint.cover({ ...part, left: 300 }, 0.01)).toBeDefined();
    expect(repaint.cover({ ...part, left: 300 }, 0.1)).toBeDefined();
    repaint.forget(); // the camera may be another now
    expect(repaint.cover({ ...part, left: 300 }, 0.01)).toBeDefined();
  });

  it("draws anew from where something went, too", () => {
    const repaint = new Repaint();
    const [here, there] = [
      { left: 110, top: 60, width: 20, height: 20 },
      { left: 150, top: 100, width: 20, height: 20 },
    ];
    expect(repaint.next(here, TILE)).toEqual(here);
    expect(repaint.next(there, TILE)).toEqual({ left: 110, top: 60, width: 60, height: 60 });
    expect(repaint.next(there, TILE)).toEqual(there);
    repaint.forget();
    expect(repaint.next(here, TILE)).toEqual(here);
  });

  it("stays within the tile", () => {
    expect(new Repaint().next({ left: 0, top: 0, width: 1000, height: 1000 }, TILE)).toEqual(TILE);
  });
});
