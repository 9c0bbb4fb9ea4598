import { expect, it } from "vitest";
import type { KeyPress } from "../../ui/gestures";
import { cueCommandOf } from "./cue_keys";

const press = (code: string, more: Partial<KeyPress> = {}): KeyPress => ({
  key: code,
  code,
  shiftKey: false,
  ctrlKey: false,
  altKey: false,
  metaKey: false,
  repeat: false,
  ...more,
});

it("plays by the space bar, and edits by Alt", () => {
  expect(cueCommandOf(press("Space"), false)).toBe("go");
  expect(cueCommandOf(press("Space", { shiftKey: true }), false)).toBe("back");
  expect(cueCommandOf(press("ArrowDown"), false)).toBe("later");
  expect(cueCommandOf(press("ArrowDown", { altKey: true }), false)).toBe("move_down");
  expect(cueCommandOf(press("KeyU"), false)).toBe("update");
  expect(cueCommandOf(press("KeyV"), false)).toBe("bus");
  expect(cueCommandOf(press("KeyZ"), false)).toBeNull();
});

it("never counts a key that is held down, which still is nobody else's", () => {
  expect(cueCommandOf(press("Space", { repeat: true }), false)).toBe("nothing");
  expect(cueCommandOf(press("ArrowUp", { repeat: true }), false)).toBe("nothing");
});

it("leaves a field and the browser their keys", () => {
  expect(cueCommandOf(press("Space"), true)).toBeNull();
  expect(cueCommandOf(press("KeyP", { ctrlKey: true }), false)).toBeNull();
  expect(cueCommandOf(press("Space", { altKey: true }), false)).toBeNull();
});
