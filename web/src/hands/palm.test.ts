import { expect, it } from "vitest";
import { handShape, palmOf, palmTurn, widthAngle } from "./palm";
import { STILL, seededNumbers, syntheticHand } from "./synthetic_hand";

it("sees the same shape of a hand however it is turned", () => {
  const random = seededNumbers(1);
  for (let count = 0; count < 50; count++) {
    const does = { ...STILL, opening: random(), index: 2 * random() - 1, little: 2 * random() - 1 };
    const [yaw, pitch, roll] = [2 * random() - 1, 2 * random() - 1, 2 * random() - 1];
    const still = handShape(syntheticHand(does), 640, 480);
    const turned = handShape(syntheticHand({ ...does, yaw, pitch, roll }, { x: random() }), 640, 480);
    still?.slice(63).forEach((value, place) => {
      expect(turned?.[63 + place]).toBeCloseTo(value, 5);
    });
  }
});

it("tells by how much the palm has turned, about its own axes", () => {
  const rest = palmOf(syntheticHand(STILL).world)?.axes ?? [];
  const random = seededNumbers(2);
  for (let count = 0; count < 50; count++) {
    const turn = { yaw: 2 * random() - 1, pitch: 2 * random() - 1, roll: 2 * random() - 1 };
    const now = palmOf(syntheticHand({ ...STILL, ...turn }).world)?.axes ?? [];
    const found = palmTurn(now, rest);
    [turn.yaw, turn.pitch, turn.roll].forEach((value, axis) => {
      expect(found[axis]).toBeCloseTo(0.4 * value, 5);
    });
    if (turn.yaw ** 2 > 0.01) expect(widthAngle(now, rest)).toBeGreaterThan(0);
  }
});

it("finds no palm in points that lie at one place, or in a line", () => {
  expect(palmOf(new Float32Array(63))).toBeNull();
  expect(palmOf(Float32Array.from({ length: 63 }, (_, place) => Math.floor(place / 3)))).toBeNull();
  expect(palmOf(new Float32Array(63).fill(Number.NaN))).toBeNull();
});
