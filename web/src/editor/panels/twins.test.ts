import { expect, it } from "vitest";
import { twinOf } from "./twins";

it("finds the muscle on the other side, and back again; those on the midline stay", () => {
  for (const [left, right] of [
    ["zygomaticus_left", "zygomaticus_right"],
    ["mentalis", "mentalis"],
    ["left_out", "left_out"],
  ] as const) {
    expect(twinOf(left)).toBe(right);
    expect(twinOf(right)).toBe(left);
  }
});
