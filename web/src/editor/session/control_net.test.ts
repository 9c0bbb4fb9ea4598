import { expect, it } from "vitest";
import { mirrorMuscle } from "./control_net";

it("finds the muscle on the other side, and back again; those on the midline stay", () => {
  for (const [left, right] of [
    ["zygomaticus_left", "zygomaticus_right"],
    ["mentalis", "mentalis"],
    ["left_out", "left_out"],
  ] as const) {
    expect(mirrorMuscle(left)).toBe(right);
    expect(mirrorMuscle(right)).toBe(left);
  }
});
