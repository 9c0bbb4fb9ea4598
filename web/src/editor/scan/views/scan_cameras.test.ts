import { describe, expect, it } from "vitest";
import type { Triple } from "../../canvas/math/vectors";
import { normalsOf, type ScanSurface, type SeenScan } from "../data/scan_document";
import { boxesOf, isHidden, pick, ScanCameras } from "./scan_cameras";

/** An octahedron of a head's size. */
function octahedron(): ScanSurface {
  const positions = Float32Array.from(
    [1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1].map((part) => 0.1 * part),
  );
  const sides = [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5];
  const triangles = Uint32Array.from(sides);
  return { positions, triangles, normals: normalsOf(positions, triangles), colours: null };
}

const scanOf = (surface: ScanSurface): SeenScan => ({ surface, face: null }) as SeenScan;

function camerasOf(surface: ScanSurface): ScanCameras {
  const cameras = new ScanCameras(scanOf(surface));
  cameras.resize(900, 300);
  return cameras;
}

describe("the three looks", () => {
  it.each([
    [1280, 600],
    [700, 640],
    [500, 900],
  ])("share a canvas of %d by %d without lying over each other", (width, height) => {
    const boxes = boxesOf(width, height);
    expect(boxes).toHaveLength(3);
    const inside = boxes.every(
      (box) => box.left >= 0 && box.top >= 0 && box.left + box.width <= width && box.top + box.height <= height,
    );
    expect(inside).toBe(true);
    for (const [at, one] of boxes.entries())
      for (const other of boxes.slice(at + 1)) {
        const apart = one.left + one.width <= other.left || one.top + one.height <= other.top;
        expect(apart).toBe(true);
      }
    const area = boxes.reduce((sum, box) => sum + box.width * box.height, 0);
    expect(area / (width * height)).toBeGreaterThan(0.97);
  });

  it("look at the face from ahead, from its left, and between", () => {
    const cameras = camerasOf(octahedron());
    expect(cameras.camera(0).back).toEqual([0, 0, 1]);
    expect(cameras.camera(2).back[0]).toBeCloseTo(1, 9);
    expect(cameras.camera(1).back[0]).toBeGreaterThan(0.4);
  });

  it("turn each by itself, and back to where they were", () => {
    const cameras = camerasOf(octahedron());
    cameras.turn(0, 50, 10);
    expect(cameras.camera(0).back[0]).toBeLessThan(-0.1);
    expect(cameras.camera(2).back[0]).toBeCloseTo(1, 9);
    cameras.reset();
    expect(cameras.camera(0).back).toEqual([0, 0, 1]);
  });
});

describe("a closer look", () => {
  it("keeps what lies under the pointer, and shifts with a hand", () => {
    const cameras = camerasOf(octahedron());
    const before = cameras.camera(0);
    const point: Triple = [0.05, 0.04, before.middle[2]];
    const [x, y] = before.project(point);
    cameras.zoom(0, 2, x, y);
    const [nearX, nearY] = cameras.camera(0).project(point);
    expect(nearX).toBeCloseTo(x, 4);
    expect(nearY).toBeCloseTo(y, 4);
    cameras.shift(0, 7, -5);
    const [movedX, movedY] = cameras.camera(0).project(point);
    expect(movedX - nearX).toBeCloseTo(7, 4);
    expect(movedY - nearY).toBeCloseTo(-5, 4);
  });
});

describe("a place of the canvas", () => {
  it("means the point of the surface that is drawn there", () => {
    const surface = octahedron();
    const camera = camerasOf(surface).camera(0);
    const point: Triple = [0.03, 0.02, 0.05]; // on the face x + y + z = 0.1
    const [x, y] = camera.project(point);
    pick(surface, camera, x, y)?.forEach((part, axis) => {
      expect(part).toBeCloseTo(point[axis] as number, 6);
    });
    expect(pick(surface, camera, 1, 1)).toBeUndefined();
  });

  it("means of a cloud, or of a surface inside out, the nearest point under the finger", () => {
    const { positions, triangles } = octahedron();
    const turned = triangles.map((_, at) => triangles[at % 3 === 0 ? at : at % 3 === 1 ? at + 1 : at - 1] as number);
    const cameras = camerasOf(octahedron());
    for (const rows of [new Uint32Array(), turned]) {
      const camera = cameras.camera(0);
      const [x, y] = camera.project([0, 0, 0.1]);
      const cloud = { positions, triangles: rows, normals: positions, colours: null };
      const ahead = pick(cloud, camera, x + 4, y);
      expect(ahead?.[2]).toBeGreaterThan(rows.length === 0 ? 0.0999 : -0.11);
    }
  });

  it("is hidden where something lies before it", () => {
    const surface = octahedron();
    const camera = camerasOf(surface).camera(0);
    expect(isHidden(surface, camera, [0, 0, -0.1])).toBe(true);
    expect(isHidden(surface, camera, [0, 0, 0.1])).toBe(false);
  });
});
