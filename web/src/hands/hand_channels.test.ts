import { expect, it } from "vitest";
import { playHand } from "./hand_channels";
import { STILL } from "./synthetic_hand";

it("opens the jaw, and plays each curl on one of its two sides", () => {
  const { weights, head } = playHand({ ...STILL, opening: 0.7, index: -0.5, little: 0.4, yaw: 1 });
  expect(weights).toMatchObject({
    jawOpen: 0.7,
    browInnerUp: 0.5,
    browDownLeft: 0,
    mouthFrownRight: 0.4,
    mouthSmileLeft: 0,
  });
  expect(head[0]).toBeCloseTo(0.49, 2);
  expect(Object.values(playHand(STILL).weights).every((value) => value === 0)).toBe(true);
});
