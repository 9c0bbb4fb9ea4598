import { expect, it } from "vitest";
import { ENOUGH, FrameChoice } from "./frame_choice";

const GOOD = { yaw: 0, sharpness: 0.6, stillness: 0.8 };

function open() {
  const released: string[] = [];
  return { released, choice: new FrameChoice<string>((picture) => released.push(picture)) };
}

it("keeps the sharpest, the stillest and the one that is turned best, and lets go of all others", () => {
  for (const better of [{ sharpness: 0.7 }, { stillness: 1 }, { yaw: 0 }]) {
    const { released, choice } = open();
    const start = { ...GOOD, yaw: 5 };
    expect(choice.offer("first", start)).toBe("front");
    expect(choice.offer("better", { ...start, ...better })).toBe("front");
    expect(choice.offer("worse", start)).toBeNull();
    expect(choice.all).toEqual([["front", "better"]]);
    expect(released).toEqual(["first", "worse"]);
  }
});

it("weighs sharpness above stillness and turn", () => {
  const { choice } = open();
  choice.offer("still and straight, but blurred", { yaw: 0, sharpness: 0.3, stillness: 1 });
  choice.offer("sharp", { yaw: 7, sharpness: 0.6, stillness: 0.3 });
  expect(choice.all).toEqual([["front", "sharp"]]);
});

it("waits for enough pictures of each direction, and for each by itself", () => {
  const { choice } = open();
  for (const yaw of [40, 20, 0, -20]) for (let count = 0; count < ENOUGH; count++) choice.offer("", { ...GOOD, yaw });
  expect([...choice.wanted]).toEqual(["right"]);
  choice.offer("", { ...GOOD, yaw: -42 });
  expect(choice.share("right")).toBeCloseTo(1 / ENOUGH);
  for (let count = 1; count < ENOUGH; count++) choice.offer("", { ...GOOD, yaw: -42 });
  expect(choice.wanted.size).toBe(0);
  expect(choice.all.map(([name]) => name)).toEqual(["left", "half left", "front", "half right", "right"]);
});

it("takes nothing between two directions or beyond, and lets go of all at the end", () => {
  const { released, choice } = open();
  expect(choice.offer("between", { ...GOOD, yaw: 11 })).toBeNull();
  expect(choice.offer("beyond", { ...GOOD, yaw: -75 })).toBeNull();
  choice.offer("kept", GOOD);
  choice.clear();
  expect(released).toEqual(["between", "beyond", "kept"]);
  expect(choice.all).toEqual([]);
});
