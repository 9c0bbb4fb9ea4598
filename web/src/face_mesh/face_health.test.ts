import { expect, it } from "vitest";
import { judgeFace, Rate } from "./face_health";
import { LANDMARK_COUNT } from "./face_mesh";
import type { Landmarks } from "./landmark_messages";

/** A face: centre, half height and how far the nose is from the middle, of the half width. */
function face({ x = 0.5, half = 0.25, turn = 0, light = 0.5, count = LANDMARK_COUNT } = {}): Landmarks {
  const points = new Float32Array(3 * count);
  for (let row = 0; row < count; row++) points.set([x, 0.5 + half * Math.sin(row), 0], 3 * row);
  if (count) {
    points[3 * 234] = x - 0.15;
    points[3 * 454] = x + 0.15;
    points[3 * 1] = x + 0.15 * turn;
  }
  return { time: 0, width: 640, height: 480, points, light, cost: 10 };
}

const bad = (landmarks: Landmarks | null, rate = 30): string[] =>
  judgeFace(landmarks, rate)
    .filter(({ good }) => !good)
    .map(({ what }) => what);

it("has nothing to say of a good picture", () => {
  expect(bad(face())).toEqual([]);
  expect(judgeFace(face(), 30).every(({ advice }) => advice === "")).toBe(true);
});

it("says what is wrong, and what to do", () => {
  expect(bad(null)).toEqual(["No face"]);
  expect(bad(face({ count: 0 }))).toEqual(["No face"]);
  expect(bad(face({ light: 0.05 }))).toEqual(["Too dark"]);
  expect(bad(face({ light: 0.99 }))).toEqual(["Too bright"]);
  expect(bad(face({ half: 0.05 }))).toEqual(["Too small"]);
  expect(bad(face({ x: 0.1 }))).toEqual(["At the edge"]);
  expect(bad(face({ half: 0.499 }))).toEqual(["Too near"]);
  expect(bad(face({ turn: 0.9 }))).toEqual(["Turned away"]);
  expect(bad(face(), 5)).toEqual(["5 pictures a second"]);
  expect(bad(face(), 1.2)).toEqual(["1 picture a second"]);
  for (const landmarks of [null, face({ light: 0.05 }), face({ turn: 0.9 }), face({ count: 0, light: 0.01 })]) {
    expect(judgeFace(landmarks, 1).every(({ good, advice }) => good || advice.length > 5)).toBe(true);
  }
});

it("counts pictures over the last two seconds", () => {
  const rate = new Rate();
  for (let time = 0; time <= 3000; time += 40) rate.count(time);
  expect(rate.count(3040)).toBeCloseTo(25, 0);
  expect(rate.count(9000)).toBe(0);
});
