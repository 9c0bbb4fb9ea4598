import { describe, expect, it } from "vitest";
import type { KeyPress } from "../../ui/gestures";
import { soloCommandOf } from "./solo_keys";

const press = (code: string, change: Partial<KeyPress> = {}): KeyPress => ({
  key: "",
  code,
  ctrlKey: false,
  altKey: false,
  metaKey: false,
  shiftKey: false,
  repeat: false,
  ...change,
});

describe("the keys of one person", () => {
  it("call looks, lines and cues", () => {
    expect(soloCommandOf(press("Digit3"), false)).toEqual({ do: "look", name: "3" });
    expect(soloCommandOf(press("KeyW"), false)).toEqual({ do: "line", index: 1 });
    expect(soloCommandOf(press("Space"), false)).toEqual({ do: "go" });
    expect(soloCommandOf(press("Space", { shiftKey: true }), false)).toEqual({ do: "back" });
  });

  it("do nothing again while they are held, and nothing in a field or with Ctrl", () => {
    expect(soloCommandOf(press("Space", { repeat: true }), false)).toEqual({ do: "nothing" });
    expect(soloCommandOf(press("Space"), true)).toBeNull();
    expect(soloCommandOf(press("KeyZ", { ctrlKey: true }), false)).toBeNull();
    expect(soloCommandOf(press("Digit3", { shiftKey: true }), false)).toBeNull();
  });
});
