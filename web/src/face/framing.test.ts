import { describe, expect, it } from "vitest";
import {
  boxOf,
  cameraPosition,
  following,
  frame,
  headColumns,
  type PictureBox,
  PORTRAIT,
  type Point,
  portraitCamera,
  type Shot,
} from "./framing";

const shot: Shot = { centre: [0, -0.01, 0.05], height: 0.3, width: 0.23 };
const half = Math.tan((portraitCamera().fov * Math.PI) / 360);

/** Where a point lies in the picture, -1..1 from edge to edge. */
function seen(point: Point, from: Point, aspect: number): [number, number] {
  const reach = (from[2] - point[2]) * half;
  return [(point[0] - from[0]) / (reach * aspect), (point[1] - from[1]) / reach];
}

/** A head with a muzzle of `long` metres, turned by `yaw`. */
function head(long: number, yaw: number): Point[] {
  const points: Point[] = [
    [-0.08, 0, 0],
    [0.08, 0, 0],
    [0, -0.2, 0.02],
    [0, 0.12, 0.02],
    [0, 0, -0.1],
    [0, -0.02, long],
  ];
  const [c, s] = [Math.cos(yaw), Math.sin(yaw)];
  return points.map(([x, y, z]) => [c * x + s * z, y, c * z - s * x]);
}

describe("the position of the camera", () => {
  it("is the shot's own where everything fits", () => {
    const from = cameraPosition(shot, head(0.13, 0), half, 16 / 9);
    expect(from).toEqual([0, -0.01, 0.05 + shot.height / 2 / half]);
  });

  it("holds muzzles, ears and crowns at every turn and in every picture", () => {
    for (const aspect of [0.5, 0.9, 16 / 9])
      for (const long of [0.12, 0.18, 0.26])
        for (let yaw = -1.6; yaw <= 1.6; yaw += 0.1) {
          const points = head(long, yaw);
          const from = cameraPosition(shot, points, half, aspect);
          for (const point of points) {
            const [across, up] = seen(point, from, aspect);
            expect(Math.abs(across)).toBeLessThan(1);
            expect(up).toBeLessThan(1);
          }
        }
  });

  it("moves as smoothly as the head turns and grows", () => {
    for (let yaw = -1.6; yaw <= 1.6; yaw += 0.01) {
      const a = cameraPosition(shot, head(0.25, yaw), half, 0.9);
      const b = cameraPosition(shot, head(0.25, yaw + 1e-4), half, 0.9);
      for (const axis of [0, 1, 2] as const) expect(Math.abs(b[axis] - a[axis])).toBeLessThan(1e-3);
    }
  });
});

describe("a shot that follows a head", () => {
  it("is the shot itself while the head is straight, or while nothing is known of it", () => {
    expect(following(shot, head(0.13, 0), head(0.13, 0))).toEqual(shot);
    expect(following(shot, [], [])).toEqual(shot);
  });

  it("moves as the head does, whatever the neck does", () => {
    const straight = head(0.13, 0);
    const moved = straight.map(([x, y, z]): Point => [x + 0.03, y < -0.1 ? y - 1 : y + 0.01, z]);
    expect(following(shot, straight, moved).centre[0]).toBeCloseTo(shot.centre[0] + 0.03);
    expect(following(shot, straight, moved).centre[1]).toBeCloseTo(shot.centre[1] + 0.01);
  });

  it("has a turned head as far from the left edge as from the right one", () => {
    for (const yaw of [-0.9, -0.3, 0.6]) {
      const turned = head(0.13, yaw);
      const across = turned.map(([x]) => x - following(shot, head(0.13, 0), turned).centre[0]);
      expect(Math.min(...across) + Math.max(...across)).toBeCloseTo(0);
    }
  });
});

describe("the columns of a picture that a head lies in", () => {
  it("hold every point of it, and fewer columns of a wider picture", () => {
    const camera = portraitCamera();
    const widths = [450, 800, 1600].map((width) => {
      const points = head(0.13, 0.5);
      frame(camera, shot, points, width, 450);
      const [left, right] = headColumns(camera, points);
      for (const point of points) {
        const at = (1 + seen(point, camera.position.toArray(), camera.aspect)[0]) / 2;
        expect(at).toBeGreaterThan(left);
        expect(at).toBeLessThan(right);
      }
      return right - left;
    });
    expect(widths[0]).toBeLessThanOrEqual(1);
    expect(widths[1]).toBeLessThan(widths[0] as number);
    expect(widths[2]).toBeCloseTo((widths[1] as number) / 2);
  });

  it("stay inside the picture where the head does not", () => {
    const camera = portraitCamera();
    frame(camera, shot, [], 100, 450);
    const [left, right] = headColumns(camera, [
      [-3, 0, 0],
      [0.01, 0, 0],
    ]);
    expect(left).toBe(0);
    expect(right).toBeLessThanOrEqual(1);
    expect(headColumns(camera, [[9, 0, 0]])).toEqual([1, 1]);
  });
});

describe("the box of a head", () => {
  it("holds its points as the picture shows them, and is none beside the picture", () => {
    const camera = portraitCamera();
    frame(camera, PORTRAIT, [], 200, 100);
    const box = boxOf(camera, [
      [-0.05, -0.1, 0.05],
      [0.1, 0.08, 0.05],
    ]) as PictureBox;
    const [left, top, right, bottom] = box;
    expect((right - left) / (bottom - top)).toBeCloseTo(0.15 / 0.18 / 2, 9); // of a picture twice as wide as high
    expect(left + right).toBeGreaterThan(1);
    expect([left, top, 1 - right, 1 - bottom].every((part) => part > 0)).toBe(true);
    for (const points of [[], [[2, 0, 0]], [[0, -2, 0]]] as Point[][]) expect(boxOf(camera, points)).toBeNull();
  });
});
