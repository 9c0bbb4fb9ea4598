import { describe, expect, it } from "vitest";
import { bounded, boundsOf, Camera, FIRST_VIEW, VIEWS, type View } from "./camera";
import { add, cross, minus, size, type Triple, times } from "./vectors";

const BOX = { left: 40, top: 30, width: 500, height: 400 };
const BOUNDS = { centre: [0, 0, 0.06] as Triple, radius: 0.13 };
const camera = (view: Partial<View> = {}): Camera => new Camera({ ...FIRST_VIEW, ...view }, BOX, BOUNDS);

describe("Camera", () => {
  it("sees the middle of the head in the middle of its box", () => {
    for (const view of [{}, { yaw: 1.2, pitch: -0.4 }, { zoom: 5 }]) {
      const [x, y] = camera(view).project(BOUNDS.centre);
      expect(x).toBeCloseTo(290, 3);
      expect(y).toBeCloseTo(230, 3);
    }
  });

  it("looks along a ray at what it projects there", () => {
    const seen = camera({ yaw: 0.7, pitch: 0.3, zoom: 2, pan: [0.02, -0.01] });
    for (const point of [
      [0.05, 0.02, 0.1],
      [-0.03, -0.06, 0.12],
    ] as Triple[]) {
      const [x, y] = seen.project(point);
      const off = minus(point, seen.eye);
      expect(size(cross(seen.ray(x, y), off))).toBeLessThan(1e-6);
    }
  });

  it("holds the whole head at zoom 1, in tall boxes too", () => {
    for (const box of [BOX, { ...BOX, width: 120 }]) {
      const seen = new Camera(FIRST_VIEW, box, BOUNDS);
      for (const side of [-1, 1]) {
        const [x] = seen.project(add(BOUNDS.centre, [side * BOUNDS.radius * 0.95, 0, 0]));
        expect(x).toBeGreaterThan(box.left);
        expect(x).toBeLessThan(box.left + box.width);
      }
    }
  });

  it("shows the character's left on the right, up above, and from the left side the nose on the left", () => {
    const front = camera();
    expect(front.project([0.05, 0, 0.06])[0]).toBeGreaterThan(290);
    expect(front.project([0, 0.05, 0.06])[1]).toBeLessThan(230);
    const [yaw, pitch] = VIEWS.left;
    expect(camera({ yaw, pitch }).project([0, 0, 0.16])[0]).toBeLessThan(290);
  });

  it("measures what a pixel covers", () => {
    const seen = camera({ yaw: 0.4, zoom: 3 });
    const metresPerPixel = seen.metresPerPixel(BOUNDS.centre);
    const [x] = seen.project(add(BOUNDS.centre, times(seen.right, metresPerPixel)));
    expect(x - seen.project(BOUNDS.centre)[0]).toBeCloseTo(1, 3);
  });
});

it("never turns the head upside down nor loses it", () => {
  const view = bounded({ yaw: 9, pitch: 3, zoom: 1000, pan: [5, -5] }, 0.1);
  expect(Math.abs(view.yaw)).toBeLessThanOrEqual(Math.PI);
  expect(view.pitch).toBeLessThan(Math.PI / 2);
  expect(view.zoom).toBeLessThan(100);
  expect(view.pan).toEqual([0.1, -0.1]);
});

it("bounds points", () => {
  expect(boundsOf(Float32Array.from([-1, 0, 0, 3, 1, 0.5]))).toEqual({ centre: [1, 0.5, 0.25], radius: 2 });
});
