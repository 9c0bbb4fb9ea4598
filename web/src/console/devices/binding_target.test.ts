import { expect, it } from "vitest";
import { FIRST_BINDING } from "./binding_fields";
import {
  BLACK_TARGET,
  barTarget,
  bindingsByTarget,
  callTarget,
  channelTarget,
  characterOf,
  clipTarget,
  directionTarget,
  isLevel,
  type Labels,
  layerTarget,
  lightTarget,
  memoryTarget,
  panicTarget,
  releaseTarget,
  shortControl,
  shortControls,
  stopClipsTarget,
  type Target,
  targetKey,
  targetText,
  whoOf,
} from "./binding_target";

const LABELS: Labels = { label: (_, name) => name.toUpperCase(), character: (name) => (name === "*" ? "all" : name) };
const EACH: readonly (readonly [Target, string, boolean])[] = [
  [channelTarget("one", "jawOpen"), "JAWOPEN of one", true],
  [barTarget("*", "face"), "face T-bar of all", true],
  [layerTarget("one", "lips", null), "influence of lips of one", true],
  [layerTarget("*", "lips", "mouth"), "influence of lips on mouth of all", true],
  [directionTarget("one", "head", "yaw"), "head yaw of one", true],
  [directionTarget("one", "gaze", "pitch"), "gaze pitch of one", true],
  [callTarget("one", "face", "old", 2), "face OLD, 2 s of one", false],
  [callTarget("one", "expression", "joy", null), "expression JOY, by hand of one", false],
  [lightTarget("theatre", 1), "light theatre, 1 s", false],
  [memoryTarget("3", 1), "memory 3, 1 s", false],
  [clipTarget("one", "a line"), "clip a line of one", false],
  [stopClipsTarget("*"), "stop clip of all", false],
  [BLACK_TARGET, "black", true],
  [{ to: "/omote/fade_to_black", axis: "", arguments: [3] }, "fade to black, 3 s", false],
  [{ to: "/omote/one/enter", axis: "", arguments: [1] }, "enter, 1 s of one", false],
  [panicTarget("one"), "panic of one", false],
  [releaseTarget("one", "face"), "let go of the face T-bar of one", false],
  [{ to: "/omote/panic", axis: "", arguments: [] }, "panic", false],
  [{ to: "bank:eyes", axis: "", arguments: [] }, "turn to bank eyes", false],
];

it.each(EACH)("says what %o plays", (target, text, level) => {
  expect([targetText(target, LABELS), isLevel(target)]).toEqual([text, level]);
});

it("tells targets apart, but not by the seconds of a call", () => {
  const keys = EACH.map(([target]) => targetKey(target));
  expect(new Set(keys).size).toBe(keys.length);
  expect(targetKey(callTarget("one", "face", "old", 2))).toBe(targetKey(callTarget("one", "face", "old", null)));
  expect(characterOf("/omote/light")).toBe("");
});

it("names one character, all, or some as addresses do", () => {
  expect([whoOf(["one"]), whoOf(["*"]), whoOf(["one", "two"])]).toEqual(["one", "*", "{one,two}"]);
});

it("finds the bindings of a target", () => {
  const [one, two] = ["a", "b"].map((control) => ({ ...FIRST_BINDING, control, to: "/omote/one/panic" }));
  const groups = bindingsByTarget([one, two, FIRST_BINDING] as (typeof FIRST_BINDING)[]);
  expect(groups.get(targetKey(panicTarget("one")))).toEqual([one, two]);
});

it("tells the controls of two devices of one name apart, and of one alone names no number", () => {
  const [one, two] = ["Pad (045e:02ea)", "Pad (045e:02ea) 2"];
  const of = (device: string) => ["axis0", "axis1", "axis0"].map((control) => ({ device, control }));
  expect(shortControls(of(one), [one, "Pad (1234:0001)"])).toBe("a0 a1");
  expect(shortControls(of(two), [two, two])).toBe("a0 a1");
  expect([one, two].map((device) => shortControls(of(device), [one, two, two]))).toEqual(["1: a0 a1", "2: a0 a1"]);
  expect(shortControls([...of(one), { device: two, control: "button3" }], [one, two])).toBe("1: a0 a1 2: b3");
});

it.each([
  ["1/cc7", "cc7"],
  ["2/cc7", "2/cc7"],
  ["1/note60", "n60"],
  ["button12", "b12"],
  ["axis0", "a0"],
  ["trigger6", "t6"],
  ["1/bend", "bend"],
])("writes %s short", (control, short) => {
  expect(shortControl(control)).toBe(short);
});
