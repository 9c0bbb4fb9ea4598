import { expect, test } from "vitest";
import { peaksOf, wavePath } from "./waveform";

test("a sound is drawn by the loudest of each part, of the loudest of all", () => {
  expect(peaksOf(Float32Array.of(0, 0.25, -0.5, 0, 0.125, 0), 3)).toEqual([0.5, 1, 0.25]);
  expect(peaksOf(Float32Array.of(0.5, -0.25), 4)).toEqual([1, 1, 0.5, 0.5]);
  expect(peaksOf(new Float32Array(8), 2)).toEqual([0, 0]);
  expect(peaksOf(new Float32Array(0), 2)).toEqual([0, 0]);
});

test("its path goes there above and back below", () => {
  expect(wavePath([0, 1])).toBe("M0.0 50.0L1000.0 4.0L1000.0 96.0L0.0 50.0Z");
  expect(wavePath([])).toBe("");
});
