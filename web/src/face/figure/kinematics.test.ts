import { describe, expect, it } from "vitest";
import { reachFoot } from "./legs";
import {
  cross,
  dot,
  frameOf,
  inverse,
  length,
  minus,
  plus,
  product,
  quaternionOf,
  type Rotation,
  rotationOf,
  scaled,
  shortestTurn,
  turnedBy,
  twistAbout,
  unit,
  type Vector,
  vectorOf,
} from "./rotations";

/** Vectors that lie all around, longer and shorter. */
const VECTORS = Array.from({ length: 60 }, (_, n): Vector => {
  const [angle, height] = [2.4 * n, 1 - (2 * n + 1) / 60];
  const wide = Math.sqrt(1 - height * height);
  return scaled([wide * Math.cos(angle), height, wide * Math.sin(angle)], 0.2 + (n % 7) * 0.4);
});

const far = (a: readonly number[], b: readonly number[]): number =>
  Math.max(...a.map((value, at) => Math.abs(value - (b[at] as number))));

describe("rotations", () => {
  it("come back from vectors, quaternions and products", () => {
    for (const vector of VECTORS) {
      const turn = rotationOf(vector);
      expect(far(product(turn, inverse(turn)), rotationOf([0, 0, 0]))).toBeLessThan(1e-12);
      expect(far(rotationOf(vectorOf(turn)), turn)).toBeLessThan(1e-7);
      expect(Math.hypot(...quaternionOf(turn))).toBeCloseTo(1, 12);
      const twist = scaled(unit(vector), twistAbout(turn, unit(vector)));
      expect(far(rotationOf(twist), turn)).toBeLessThan(1e-7);
    }
  });

  it("turn one direction to another, and nothing that stands on both", () => {
    for (const [n, vector] of VECTORS.entries()) {
      const [before, after] = [unit(vector), unit(VECTORS[(n + 17) % VECTORS.length] as Vector)];
      const turn = shortestTurn(before, after);
      expect(far(turnedBy(turn, before), after)).toBeLessThan(1e-9);
      const axis = cross(before, after);
      expect(far(turnedBy(turn, axis), axis)).toBeLessThan(1e-9);
      const frame: Rotation = frameOf(before, after);
      expect(far(product(frame, inverse(frame)), rotationOf([0, 0, 0]))).toBeLessThan(1e-9);
    }
  });
});

describe("a leg", () => {
  const [hip, knee, ankle]: readonly [Vector, Vector, Vector] = [
    [0.1, -0.8, 0],
    [0.1, -1.2, 0.02],
    [0.1, -1.6, 0],
  ];
  const whole = length(minus(knee, hip)) + length(minus(ankle, knee));

  it("reaches every place within its length, as long as it was, with its knee ahead", () => {
    for (const vector of VECTORS) {
      const target = plus(ankle, scaled(vector, 0.15));
      const [thigh, shin] = reachFoot(hip, knee, ankle, target, [0, 0, 1]);
      const bent = plus(hip, turnedBy(thigh, minus(knee, hip)));
      const end = plus(bent, turnedBy(shin, minus(ankle, knee)));
      const wanted = length(minus(target, hip));
      expect(length(minus(end, target))).toBeLessThan(Math.max(1e-9, wanted - 0.9995 * whole + 1e-9));
      const along = unit(minus(end, hip));
      const aside = minus(minus(bent, hip), scaled(along, dot(minus(bent, hip), along)));
      expect(aside[2]).toBeGreaterThan(0);
    }
  });
});
