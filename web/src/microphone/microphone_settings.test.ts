import { describe, expect, it } from "vitest";
import { FIRST, keepSettings, readSettings, withSpeaker } from "./microphone_settings";

function storeOf(text: string | null = null) {
  let kept = text;
  return () => ({
    getItem: () => kept,
    setItem: (_: string, value: string) => {
      kept = value;
    },
  });
}
const SPEAKER = { bands: [-30, -40], level: -34 };

describe("the settings of a microphone", () => {
  it("come back as they were kept", () => {
    const store = storeOf();
    const settings = withSpeaker({ ...FIRST, name: "Anna", device: "desk", mode: "push" }, SPEAKER);
    keepSettings(store, settings);
    expect(readSettings(store)).toEqual(settings);
  });

  it("clean nothing at first, and are as at first where nothing can be read", () => {
    expect(Object.values(FIRST.cleaning)).toEqual([false, false, false]);
    for (const text of [
      null,
      "",
      "{",
      "3",
      "null",
      '{"mode":7,"name":"","cleaning":{"noiseSuppression":"yes"},"speakers":{"a":1}}',
    ])
      expect(readSettings(storeOf(text))).toEqual(FIRST);
    const private_ = () => {
      throw new Error("no storage");
    };
    expect(readSettings(private_)).toEqual(FIRST);
    expect(() => keepSettings(private_, FIRST)).not.toThrow();
  });

  it("know a speaker by the device, and forget it", () => {
    const measured = withSpeaker({ ...FIRST, device: "desk" }, SPEAKER);
    expect(measured.speakers).toEqual({ desk: SPEAKER });
    expect(withSpeaker(measured, null).speakers).toEqual({});
  });
});
