import { expect, it } from "vitest";
import { type Grey, sharpnessOf } from "./sharpness";

const SIDE = 64;

/** A pattern of edges, blurred over so many pixels on either side, along one axis or both. */
function drawn(across: number, down = across, light = 1): Grey {
  const edge = (at: number): number => (Math.floor(at / 23) % 2) * 160;
  const mean = (at: number, reach: number): number => {
    let sum = 0;
    for (let off = -reach; off <= reach; off++) sum += edge(at + off + 700);
    return sum / (2 * reach + 1);
  };
  const values = Float32Array.from(
    { length: SIDE * SIDE },
    (_, place) => light * (mean(place % SIDE, across) + mean(Math.floor(place / SIDE), down)),
  );
  return { values, width: SIDE, rows: SIDE };
}

it("falls with every pixel of blur", () => {
  const measures = [0, 1, 2, 4, 8].map((reach) => sharpnessOf(drawn(reach)));
  expect(measures).toEqual([...measures].sort((measure, other) => other - measure));
  expect(measures[0]).toBeGreaterThan(0.6);
  expect(measures.at(-1)).toBeLessThan(0.3);
});

it("is that of the axis along which something moved", () => {
  const still = sharpnessOf(drawn(0));
  expect(sharpnessOf(drawn(4, 0))).toBeLessThan(0.7 * still);
  expect(sharpnessOf(drawn(4, 0))).toBeCloseTo(sharpnessOf(drawn(0, 4)), 5);
});

it("does not ask how light a picture is, and finds nothing sharp in a wall", () => {
  expect(sharpnessOf(drawn(1, 1, 0.2))).toBeCloseTo(sharpnessOf(drawn(1)), 4);
  expect(sharpnessOf(drawn(0, 0, 0))).toBe(0);
});

it("takes pictures that are no squares", () => {
  const { values } = drawn(0);
  const wide = { values: values.subarray(0, 32 * SIDE), width: SIDE, rows: 32 };
  expect(sharpnessOf(wide)).toBeGreaterThan(0.5);
});
