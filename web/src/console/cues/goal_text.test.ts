import { describe, expect, it } from "vitest";
import { firstGoal, type Goal, goalText, parseGoal } from "./goal_text";

const BOTH: readonly (readonly [string, Goal, string])[] = [
  ["one/face", { dog: 1 }, "dog"],
  ["one/expression", { joy: 0.7, neutral: 0.3 }, "joy = 0.7, neutral = 0.3"],
  ["one/expression", { face: 1 }, "face"],
  ["one/brows", {}, "face"],
  ["one/brows", { face: 1 }, "face = 1"],
  ["one/clip", { "line 1": 1 }, "line 1"],
  ["one/clip", {}, "stop"],
  ["one/clip", { stop: 1 }, "stop = 1"],
  ["one/head", { yaw: -0.2, pitch: 1e-7, roll: 0 }, "yaw = -0.2, pitch = 1e-7, roll = 0"],
  ["one/presence", { presence: 0.1 }, "0.1"],
  ["*/black", { black: 1 }, "1"],
  ["one/layer:tracker", { brows: 0.5, eyes: 0.5, mouth: 0.5, rest: 0.5, head: 0.5, gaze: 0.5 }, "0.5"],
  ["one/look", { "character two": 1 }, "character two"],
  ["one/look", { x: 1, y: 0, z: 2 }, "x = 1, y = 0, z = 2"],
  ["*/framing", { "*": 1 }, "*"],
  ["*/framing", { "ben+kaori": 0.25, "*": 0.75 }, '"ben+kaori" = 0.25, "*" = 0.75'],
  ["one/face", { 'a "b" = c, d': 1 }, '"a \\"b\\" = c, d" = 1'],
];

describe("goals as text", () => {
  it.each(BOTH)("%s %j is %s, and back", (part, goal, text) => {
    expect(goalText(part, goal)).toBe(text);
    expect(parseGoal(part, text)).toEqual(goal);
  });

  it("reads what the text files have too", () => {
    expect(parseGoal("one/expression", "{ joy = 0.7, neutral = 0.3 }")).toEqual({ joy: 0.7, neutral: 0.3 });
    expect(parseGoal("one/face", '"dog"')).toEqual({ dog: 1 });
    expect(parseGoal("one/face", "my face")).toEqual({ "my face": 1 });
  });

  it("comes back from what it begins with", () => {
    for (const part of ["one/head", "one/gaze", "one/place", "one/presence", "one/motion", "one/layer:lips", "*/black"])
      expect(goalText(part, parseGoal(part, firstGoal(part)))).toBe(firstGoal(part));
  });

  it.each([
    ["one/face", " ", "Give where one/face goes"],
    ["one/head", "0.5", "yaw = 0, pitch = 0, roll = 0"],
    ["*/black", "dark", "*/black goes to numbers: 1."],
    ["one/expression", "joy = much", '"much" is no number for joy'],
    ["one/expression", "joy = 0,7", '"7" is no goal'],
  ])("%s does not go to %s, in words", (part, text, words) => {
    expect(() => parseGoal(part, text)).toThrow(words);
  });
});
