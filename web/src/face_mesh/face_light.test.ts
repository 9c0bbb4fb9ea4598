import { expect, it } from "vitest";
import { faceBox, meanLight } from "./face_light";

it("measures the light of pixels", () => {
  expect(meanLight(new Uint8ClampedArray([255, 255, 255, 255, 0, 0, 0, 255]))).toBeCloseTo(0.5);
  expect(meanLight(new Uint8ClampedArray())).toBe(0);
});

it("finds the box of a face, within the picture", () => {
  expect(faceBox(new Float32Array([0.25, 0.5, 0, 0.75, 1.5, 0]), 400, 200)).toEqual([100, 100, 200, 100]);
  expect(faceBox(new Float32Array(), 400, 200)).toEqual([0, 0, 400, 200]);
});
