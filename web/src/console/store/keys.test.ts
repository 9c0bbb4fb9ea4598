import { describe, expect, it } from "vitest";
import type { KeyPress } from "../../ui/gestures";
import { commandOf, EXPRESSION_KEYS, FACE_KEYS, keyLabel } from "./keys";

const press = (key: string, code = "", more: Partial<KeyPress> = {}): KeyPress => ({
  key,
  code,
  ctrlKey: false,
  altKey: false,
  metaKey: false,
  repeat: false,
  ...more,
});

describe("a key", () => {
  it("panics always: while typing, held down, with any other key", () => {
    expect(commandOf(press("Escape"), true)).toEqual({ do: "panic" });
    expect(commandOf(press("Escape", "Escape", { repeat: true, ctrlKey: true }), false)).toEqual({ do: "panic" });
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
