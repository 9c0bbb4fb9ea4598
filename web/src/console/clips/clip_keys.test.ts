import { describe, expect, it } from "vitest";
import { clipCommandOf } from "./clip_keys";

const press = (code: string, more: object = {}) => ({
  key: "",
  code,
  ctrlKey: false,
  altKey: false,
  metaKey: false,
  shiftKey: false,
  repeat: false,
  ...more,
});

describe("the keys of the clip page", () => {
  it("are a transport's", () => {
    expect(clipCommandOf(press("Space"), false)).toEqual({ do: "play" });
    expect(clipCommandOf(press("KeyR"), false)).toEqual({ do: "record" });
    expect(clipCommandOf(press("Digit3"), false)).toEqual({ do: "arm", part: "mouth", how: "only" });
    expect(clipCommandOf(press("Digit3", { shiftKey: true, key: "#" }), false)).toEqual({
      do: "arm",
      part: "mouth",
      how: "beside",
    });
    expect(clipCommandOf(press("KeyS"), false)).toEqual({ do: "slow" });
    expect(clipCommandOf(press("Digit0"), false)).toEqual({ do: "zoom", way: 0 });
    expect(clipCommandOf(press("ArrowLeft", { altKey: true, shiftKey: true }), false)).toEqual({
      do: "shift",
      seconds: -0.1,
    });
  });

  it("go on while arrows are held down, and no other", () => {
    expect(clipCommandOf(press("ArrowRight", { repeat: true }), false)).toEqual({ do: "step", seconds: 0.1 });
    expect(clipCommandOf(press("KeyR", { repeat: true }), false)).toEqual({ do: "nothing" });
  });

  it("leave fields and the browser's own keys alone", () => {
    expect(clipCommandOf(press("Space"), true)).toBeNull();
    expect(clipCommandOf(press("KeyR", { ctrlKey: true }), false)).toBeNull();
    expect(clipCommandOf(press("KeyR", { shiftKey: true }), false)).toBeNull();
    expect(clipCommandOf(press("KeyQ"), false)).toBeNull();
  });
});
