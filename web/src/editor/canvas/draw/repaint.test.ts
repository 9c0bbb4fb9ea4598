import { describe, expect, it, vi } from "vitest";
import { overlap } from "../math/boxes";
import { Camera, FIRST_VIEW } from "../math/camera";
import type { Triple } from "../math/vectors";
import { boxOf, spreadOf } from "../model/spread";
import { Repaint } from "./repaint";

const TILE = { left: 100, top: 50, width: 300, height: 400 };
const CAMERA = new Camera(FIRST_VIEW, TILE, { centre: [0, 0, 0], radius: 0.13 });
const POINTS = Float32Array.from([0.01, 0.02, 0.1, -0.03, 0.05, 0.08, 0.02, -0.06, 0.09]);

describe("spreadOf", () => {
  const tangents = new Float32Array(3 * 9);
  tangents[3] = 2; // row 1: two metres along x per radian
  tangents[9 + 6 + 1] = 5; // row 2: five metres along y per metre
  const figure = { base: POINTS, tangents };
  const field = new Float32Array(12);
  [field[4], field[9]] = [0.5, 0.1];

  it("holds each row where it was and where it is led", () => {
    const { low, high, reach } = spreadOf(figure, Uint32Array.of(1, 2), field);
    for (const [row, axis, way] of [
      [1, 0, 1],
      [2, 1, 0.5],
    ] as const) {
      const value = POINTS[3 * row + axis] as number;
      expect(low[axis]).toBeLessThanOrEqual(value);
      expect(high[axis]).toBeGreaterThanOrEqual(value + way);
    }
    expect(reach).toBeCloseTo(1);
    expect(spreadOf(figure, Uint32Array.of(2), field).reach).toBeCloseTo(0.5);
    expect(spreadOf(figure, Uint32Array.of(2), undefined).reach).toBe(0);
  });

  it("is a box on the screen that holds them all, with its border", () => {
    const box = boxOf(CAMERA, spreadOf(figure, Uint32Array.of(0, 1, 2), undefined), 0.01);
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
    const { width, height } = overlap(boxOf(CAMERA, spreadOf(figure, new Uint32Array(), field), 0), TILE);
    expect(width > 0 && height > 0).toBe(false);
  });
});

const SURFACE = { rows: Uint16Array.of(0, 1, 2), triangles: Uint16Array.of(0, 1, 2) };
const PAINTER = {
  surface: () => SURFACE as never,
  list: vi.fn((triangles: Uint16Array) => ({ buffer: {} as WebGLBuffer, count: triangles.length })),
};

describe("Repaint", () => {
  it("cuts triangles anew only when a part reaches beyond the last cut", () => {
    const repaint = new Repaint(PAINTER);
    const part = { left: 150, top: 100, width: 100, height: 100 };
    PAINTER.list.mockClear();
    repaint.triangles(1, part, CAMERA, POINTS, 0.01);
    repaint.triangles(1, { ...part, left: 160 }, CAMERA, POINTS, 0.015);
    expect(PAINTER.list).toHaveBeenCalledTimes(1);
    repaint.triangles(1, { ...part, left: 300 }, CAMERA, POINTS, 0.01);
    repaint.triangles(1, { ...part, left: 300 }, CAMERA, POINTS, 0.1);
    expect(PAINTER.list).toHaveBeenCalledTimes(3);
    repaint.forget(); // the camera may be another now
    repaint.triangles(1, { ...part, left: 300 }, CAMERA, POINTS, 0.01);
    expect(PAINTER.list).toHaveBeenCalledTimes(4);
  });

  it("draws anew from where something went, too", () => {
    const repaint = new Repaint(PAINTER);
    const [here, there] = [
      { left: 110, top: 60, width: 20, height: 20 },
      { left: 150, top: 100, width: 20, height: 20 },
    ];
    expect(repaint.next(1, here, TILE)).toEqual(here);
    expect(repaint.next(1, there, TILE)).toEqual({ left: 110, top: 60, width: 60, height: 60 });
    expect(repaint.next(1, there, TILE)).toEqual(there);
    repaint.forget();
    expect(repaint.next(1, here, TILE)).toEqual(here);
  });

  it("stays within the tile", () => {
    const over = { left: 0, top: 0, width: 1000, height: 1000 };
    expect(new Repaint(PAINTER).next(0, over, TILE)).toEqual(TILE);
  });
});
