import { expect, it } from "vitest";
import type { Cue } from "../../link/messages";
import { cueBeside, isFound, movedBehind, standbyBeside } from "./cue_order";

const cue = (number: string, more: Partial<Cue> = {}): Cue => ({
  identity: `id${number}`,
  number,
  moves: {},
  label: "",
  note: "",
  colour: "",
  pre_wait: 0,
  post_wait: 0,
  goes_on: "",
  skip: false,
  actions: [],
  ...more,
});
const CUES = [cue("1"), cue("2", { skip: true }), cue("3"), cue("4")];

it("lets the next cue stand by that is not skipped", () => {
  expect(standbyBeside(CUES, "id1", 1)?.number).toBe("3");
  expect(standbyBeside(CUES, "id3", -1)?.number).toBe("1");
  expect(standbyBeside(CUES, "id1", -1)).toBeNull();
  expect(standbyBeside(CUES, "id4", 1)).toBeNull();
  expect(standbyBeside(CUES, null, -1)?.number).toBe("4"); // behind the end the last one is nearest
});

it("moves a cue by a place, and says behind which that is", () => {
  expect(movedBehind(CUES, "id3", -1)).toBe("id1");
  expect(movedBehind(CUES, "id2", -1)).toBe("");
  expect(movedBehind(CUES, "id3", 1)).toBe("id4");
  expect(movedBehind(CUES, "id1", -1)).toBeNull();
  expect(movedBehind(CUES, "id4", 1)).toBeNull();
  expect(cueBeside(CUES, "id4", -1)?.number).toBe("3");
  expect(cueBeside(CUES, "id4", 1)).toBeNull();
});

it("finds a cue by every word, wherever each stands", () => {
  const move = { goal: { dog: 1 }, seconds: 1, easing: "smooth", delay: 0 };
  const found = cue("12.5", { label: "The dog WAKES", moves: { "kaori/face": move } });
  expect(isFound(found, "wakes kaori 12")).toBe(true);
  expect(isFound(found, "wakes cat")).toBe(false);
  expect(isFound(found, " ")).toBe(true);
});
