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

const PLAYING = ["Space", "ArrowUp", "ArrowDown", "KeyP", "KeyA"];

it("plays by the space bar, and edits by Alt", () => {
  expect(cueCommandOf(press("Space"), "playing")).toBe("go");
  expect(cueCommandOf(press("Space", { shiftKey: true }), "playing")).toBe("back");
  expect(cueCommandOf(press("ArrowDown"), "playing")).toBe("later");
  expect(cueCommandOf(press("ArrowDown", { altKey: true }), "playing")).toBeNull();
  expect(cueCommandOf(press("ArrowDown", { altKey: true }), "editing")).toBe("move_down");
  expect(cueCommandOf(press("KeyU", { altKey: true }), "editing")).toBe("update");
  expect(cueCommandOf(press("KeyV"), "playing")).toBe("bus");
  expect(cueCommandOf(press("KeyV", { altKey: true }), "editing")).toBe("bus");
  expect(cueCommandOf(press("KeyE"), "playing")).toBe("edit");
  expect(cueCommandOf(press("Escape"), "editing")).toBe("leave");
  expect(cueCommandOf(press("KeyZ"), "playing")).toBeNull();
});

it("has no letter that missed its field play, edit or leave while cues are edited", () => {
  const letters = [..."ABCDEFGHIJKLMNOPQRSTUVWXYZ"].map((letter) => `Key${letter}`);
  for (const code of [...PLAYING, ...letters])
    for (const shiftKey of [false, true])
      expect([null, "nothing"]).toContain(cueCommandOf(press(code, { shiftKey }), "editing"));
});

it("plays while cues are edited where keys are let play", () => {
  for (const code of PLAYING)
    expect(cueCommandOf(press(code), "editing", true)).toBe(cueCommandOf(press(code), "playing"));
});

it("never counts a key that is held down, which still is nobody else's", () => {
  expect(cueCommandOf(press("Space", { repeat: true }), "playing")).toBe("nothing");
  expect(cueCommandOf(press("ArrowUp", { repeat: true }), "playing")).toBe("nothing");
});

it("leaves a field and the browser their keys", () => {
  expect(cueCommandOf(press("Space"), "field")).toBeNull();
  expect(cueCommandOf(press("KeyP", { ctrlKey: true }), "playing")).toBeNull();
  expect(cueCommandOf(press("Space", { altKey: true }), "playing")).toBeNull();
});
