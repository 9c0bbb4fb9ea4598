import { expect, it } from "vitest";
import { bloodSpots, SPOTS } from "./blood_spots";

/** The spots of one place, by name. */
const at = (x: number, y: number, z: number) => {
  const found = bloodSpots(Float32Array.of(x, y, z));
  return Object.fromEntries(SPOTS.map((spot, n) => [spot, found[n] as number]));
};

it("lies where its name says, on both sides alike, and on nothing behind", () => {
  expect(at(0.049, -0.034, 0.12).cheeks).toBeGreaterThan(0.8);
  expect(at(-0.049, -0.034, 0.12)).toEqual(at(0.049, -0.034, 0.12));
  expect(at(0, -0.034, 0.15).nose).toBeGreaterThan(0.9);
  expect(at(0, 0.044, 0.15).forehead).toBeGreaterThan(0.9);
  expect(at(0.034, -0.003, 0.14).eyes).toBeCloseTo(1, 2);
  expect(Object.values(at(0.049, -0.034, 0))).toEqual([0, 0, 0, 0]);
});
