import { expect, it } from "vitest";
import type { Recipe } from "../../../link/editing_messages";
import type { Manifest } from "../../../link/messages";
import { Camera, FIRST_VIEW } from "../math/camera";
import { ballOf, gazeOf, shows } from "./gaze";

const manifest = {
  expressions: [{ name: "wink", source: "wink", eyes: [0.1, 0.2, 0.3, 0.4], pupil: 0.5 }],
} as unknown as Manifest;
const hand = { turns: [1, 0, 0, 0], pupil: 0.1 };
const recipe = (region: string | null, mirrored: boolean): Recipe =>
  ({ layers: [{ source: "wink", label: "Wink", weight: 0.5, region, mirrored }] }) as unknown as Recipe;

it("adds up what layers and the hand do to the eyes", () => {
  expect(gazeOf(recipe(null, false), hand, manifest)).toEqual({ angles: [1.05, 0.1, 0.15, 0.2], pupil: 0.35 });
});

it("exchanges left and right where a layer is mirrored", () => {
  expect(gazeOf(recipe("eyes", true), hand, manifest).angles).toEqual([1 - 0.15, 0.2, -0.05, 0.1]);
});

it("leaves out layers of other regions, and looks ahead without a recipe", () => {
  expect(gazeOf(recipe("mouth", false), hand, manifest)).toEqual({ angles: [1, 0, 0, 0], pupil: 0.1 });
  expect(gazeOf(null, hand, manifest)).toEqual({ angles: [0, 0, 0, 0], pupil: 0 });
});

it("shows an eyeball in the parts that it reaches into", () => {
  const tile = { left: 0, top: 0, width: 300, height: 300 };
  const camera = new Camera(FIRST_VIEW, tile, { centre: [0, 0, 0], radius: 0.13 });
  const ends = [0.015, -0.015].flatMap((far) => [
    [0.03 + far, 0, 0.08],
    [0.03, far, 0.08],
    [0.03, 0, 0.08 + far],
  ]);
  const ball = ballOf({ rows: [0, 3, 1, 4, 2, 5] }, Float32Array.from(ends.flat()));
  expect(ball.radius).toBeCloseTo(0.015);
  const [x, y] = camera.project([0.03, 0, 0.08]);
  expect(shows(ball, camera, tile)).toBe(true);
  expect(shows(ball, camera, { left: x + 10, top: y - 5, width: 50, height: 10 })).toBe(true);
  expect(shows(ball, camera, { left: x + 60, top: y - 5, width: 50, height: 10 })).toBe(false);
});
