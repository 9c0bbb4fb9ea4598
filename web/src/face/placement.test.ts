import { Matrix4, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { PORTRAIT, type Point } from "./framing";
import { dropOf, placed, placeMatrix } from "./placement";
import { FRONT } from "./pose/scene_pose";

const points: Point[] = [
  [0.08, 0.13, 0.02],
  [-0.09, -0.1, 0.1],
];

describe("a place", () => {
  it("that nobody has chosen changes nothing, to the last bit", () => {
    const matrix = placeMatrix(FRONT, 0, new Matrix4());
    expect(placed(PORTRAIT, points, FRONT, matrix)).toEqual({ shot: PORTRAIT, points });
  });

  it("moves to the audience's right, away from it, and turns to the character's own left", () => {
    const at = (place: object, point: Point) =>
      new Vector3(...point).applyMatrix4(placeMatrix({ ...FRONT, ...place }, 0, new Matrix4())).toArray();
    expect(at({ x: 0.2, depth: 0.5 }, [0, 0, 0.1])).toEqual([0.2, 0, expect.closeTo(-0.4, 12)]);
    expect(at({ turn: Math.PI / 2 }, [0, 0.1, 0.13])[0]).toBeCloseTo(0.1, 12); // the nose points to the right
    expect(at({ size: 2 }, [0.1, 0.1, 0.03])).toEqual([0.2, 0.2, expect.closeTo(0.03, 12)]);
  });

  it("frames a head as large as it is", () => {
    const place = { x: 0.3, depth: 0.1, size: 0.5, turn: 0 };
    const { shot } = placed(PORTRAIT, points, place, placeMatrix(place, 0, new Matrix4()));
    expect(shot.height).toBeCloseTo(PORTRAIT.height / 2, 12);
    expect(shot.centre[0]).toBeCloseTo(0.3, 12);
  });
});

describe("who comes", () => {
  const [camera, half]: [Point, number] = [[0, 0, 1.5], 0.158];

  it("begins below the picture and ends in its place, without a jump", () => {
    const [full, none] = [dropOf(1, points, 1, camera, half), dropOf(0, points, 1, camera, half)];
    expect(full).toBe(0);
    for (const [, y, z] of points) expect(y - none).toBeLessThan(camera[1] - half * (camera[2] - z));
    for (let part = 0; part < 1; part += 0.02)
      expect(dropOf(part, points, 1, camera, half) - dropOf(part + 0.02, points, 1, camera, half)).toBeLessThan(0.02);
  });

  it("does not move who is below the picture anyway", () => {
    expect(dropOf(0, points, 1, [0, 9, 1.5], half)).toBe(0);
  });
});
