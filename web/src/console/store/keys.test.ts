import { describe, expect, it } from "vitest";
import type { KeyPress } from "../../ui/gestures";
import { commandOf, EXPRESSION_KEYS, FACE_KEYS, isPanic, keyLabel, stepOf } from "./keys";

const press = (key: string, code = "", more: Partial<KeyPress> = {}): KeyPress => ({
  key,
  code,
  ctrlKey: false,
  altKey: false,
  metaKey: false,
  shiftKey: false,
  repeat: false,
  ...more,
});

describe("a key", () => {
  it("panics with Shift and Backspace, and is otherwise nothing", () => {
    const key = press("Backspace", "Backspace", { shiftKey: true });
    expect(isPanic(key)).toBe(true);
    expect(isPanic({ ...key, shiftKey: false })).toBe(false);
    for (const shiftKey of [true, false]) expect(commandOf({ ...key, shiftKey }, false)).toBeNull();
  });

  it("that closes what is open is nothing else", () => {
    for (const typing of [true, false]) expect(commandOf(press("Escape", "Escape"), typing)).toBeNull();
    expect(isPanic(press("Escape", "Escape"))).toBe(false);
  });

  it("calls by its place on the keyboard, not by what is printed on it", () => {
    expect(commandOf(press("&", "Digit1"), false)).toEqual({ do: "call", axis: "face", index: 0 });
    expect(commandOf(press("a", "KeyQ"), false)).toEqual({ do: "call", axis: "expression", index: 0 });
    expect(commandOf(press("o", "KeyO"), false)).toEqual({ do: "call", axis: "expression", index: 8 });
  });

  it("does nothing while typing, when it repeats, or with the browser's own keys", () => {
    expect(commandOf(press("1", "Digit1"), true)).toBeNull();
    expect(commandOf(press("1", "Digit1", { repeat: true }), false)).toBeNull();
    for (const held of ["ctrlKey", "altKey", "metaKey"] as const)
      expect(commandOf(press("r", "KeyR", { [held]: true }), false)).toBeNull();
    expect(commandOf(press("F5", "F5"), false)).toBeNull();
  });

  it("takes a step back or forth with Ctrl, or Command on a Mac, and with nothing else", () => {
    for (const held of ["ctrlKey", "metaKey"] as const) {
      expect(stepOf(press("z", "KeyZ", { [held]: true }))).toBe("undo");
      expect(stepOf(press("Z", "KeyZ", { [held]: true, shiftKey: true }))).toBe("redo");
      expect(stepOf(press("y", "KeyY", { [held]: true }))).toBe("redo");
      expect(stepOf(press("z", "KeyZ", { [held]: true, altKey: true }))).toBeNull();
      expect(stepOf(press("x", "KeyX", { [held]: true }))).toBeNull();
    }
    expect(stepOf(press("z", "KeyZ"))).toBeNull();
  });

  it("leads from region to region, with Shift back", () => {
    expect(commandOf(press("d", "KeyD"), false)).toEqual({ do: "region", direction: 1 });
    expect(commandOf(press("D", "KeyD", { shiftKey: true }), false)).toEqual({ do: "region", direction: -1 });
  });

  it("calls a memory with Shift and a digit, and keeps the next one pressed", () => {
    expect(commandOf(press("!", "Digit1", { shiftKey: true }), false)).toEqual({ do: "memory", name: "1" });
    expect(commandOf(press("\\", "Backslash"), false)).toEqual({ do: "keep_memory" });
  });

  it("makes black with Shift alone, and lets go of T-bars without", () => {
    const shifted = (code: string) => commandOf(press("", code, { shiftKey: true }), false);
    expect([shifted("KeyV"), shifted("KeyB")]).toEqual([
      { do: "black", seconds: 0 },
      { do: "black", seconds: null },
    ]);
    expect(commandOf(press("b", "KeyB"), false)).toEqual({ do: "release", axis: "expression" });
  });

  it("looks at the other bus with Shift alone, and opens the scene without", () => {
    expect(commandOf(press("P", "KeyP", { shiftKey: true }), false)).toEqual({ do: "bus" });
    expect(commandOf(press("p", "KeyP"), false)).toEqual({ do: "scene" });
  });

  it("keeps what is on air", () => {
    expect(commandOf(press("n", "KeyN"), false)).toEqual({ do: "keep", axis: "face" });
    expect(commandOf(press("m", "KeyM"), false)).toEqual({ do: "keep", axis: "expression" });
  });

  it("means one thing", () => {
    const codes = [...FACE_KEYS, ...EXPRESSION_KEYS];
    expect(new Set(codes).size).toBe(18);
  });

  it("is shown on the first nine tiles", () => {
    expect(keyLabel("face", 0)).toBe("1");
    expect(keyLabel("expression", 8)).toBe("O");
    expect(keyLabel("face", 9)).toBeNull();
  });
});
