import { expect, it } from "vitest";
import { FIRST_BINDING, modeText, rangeText, readArguments } from "./binding_fields";

it("reads arguments as they are written", () => {
  expect(readArguments("old, 2")).toEqual(["old", 2]);
  expect(readArguments(" joy , hand ,")).toEqual(["joy", "hand"]);
  expect(readArguments("")).toEqual([]);
});

it("says what is set of a range, and how a control moves", () => {
  const fader = { ...FIRST_BINDING, to: "/omote/one/channel/jawOpen" };
  expect(rangeText(fader)).toBe("whole");
  expect(rangeText({ ...fader, low: 0.1234567 })).toBe("0.123 to …");
  expect(modeText(fader)).toBe("fader");
  expect(modeText({ ...fader, button: "toggle" })).toBe("toggle");
  expect(modeText({ ...fader, relative: "twos_complement" })).toBe("encoder, twos complement");
  expect(modeText({ ...fader, to: "/omote/one/panic" })).toBe("key");
});
