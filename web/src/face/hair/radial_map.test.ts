import { IcosahedronGeometry } from "three";
import { describe, expect, it } from "vitest";
import { MIDDLE, moveOutward, radialMap, radiusOf, radiusUnder } from "./radial_map";

const ball = new IcosahedronGeometry(0.1, 12).translate(...MIDDLE.toArray()).getAttribute("position").array;
const triangles = Uint32Array.from({ length: ball.length / 3 }, (_, row) => row);
const map = radialMap(ball as Float32Array, [triangles]);

describe("the radial map", () => {
  it("of a ball is its radius in every direction", () => {
    for (let turn = 0; turn < 200; turn++) {
      const [height, angle] = [1 - (2 * turn) / 199, 2.4 * turn];
      const round = Math.sqrt(1 - height * height);
      const at = [MIDDLE.x + round * Math.cos(angle), MIDDLE.y + height, MIDDLE.z + round * Math.sin(angle)] as const;
      expect(radiusUnder(map, ...at)).toBeCloseTo(0.1, 3);
      expect(radiusOf(...at)).toBeCloseTo(1);
    }
  });

  it("has no hole where there is no skin", () => {
    const half = Uint32Array.from(triangles).filter((row) => (ball[3 * (row - (row % 3)) + 1] as number) > MIDDLE.y);
    expect(radiusUnder(radialMap(ball as Float32Array, [half]), 0, -1, 0)).toBeCloseTo(0.1, 2);
  });

  it("moves a point straight away from the middle", () => {
    const at = [0.01, 0.2, -0.03] as const;
    const moved = Float32Array.from([0, ...at]);
    moveOutward(moved, 1, ...at, 0.5);
    expect(radiusOf(moved[1] as number, moved[2] as number, moved[3] as number)).toBeCloseTo(1.5 * radiusOf(...at));
  });
});
