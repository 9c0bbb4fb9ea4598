import { describe, expect, it } from "vitest";
import { firstGoal, type Goal, goalText, parseGoal, partsInOrder } from "./goal_text";

const BOTH: readonly (readonly [string, Goal, string])[] = [
  ["one/face", { dog: 1 }, "dog"],
  ["one/expression", { joy: 0.7, neutral: 0.3 }, "joy = 0.7, neutral = 0.3"],
  ["one/expression", { face: 1 }, "face"],
  ["one/brows", {}, "face"],
  ["one/brows", { face: 1 }, "face = 1"],
  ["one/clip", { "line 1": 1 }, "line 1"],
  ["one/clip", {}, "stop"],
  ["one/clip", { stop: 1 }, "stop = 1"],
  ["one/head", { yaw: -Math.PI / 9, pitch: Math.PI / 2, roll: 0 }, "yaw = -20°, pitch = 90°, roll = 0°"],
  ["one/place", { x: -0.2, depth: 1, size: 1, turn: Math.PI }, "x = -0.2, depth = 1, size = 1, turn = 180°"],
  ["one/presence", { presence: 0.1 }, "0.1"],
  ["*/black", { black: 1 }, "1"],
  ["one/layer:tracker", { brows: 0.5, eyes: 0.5, mouth: 0.5, rest: 0.5, head: 0.5, gaze: 0.5 }, "0.5"],
  ["one/look", { "character two": 1 }, "character two"],
  ["one/look", { x: 1, y: 0, z: 2 }, "x = 1, y = 0, z = 2"],
  ["*/framing", { "*": 1 }, "*"],
  ["*/framing", { "ben+kaori": 0.25, "*": 0.75 }, '"ben+kaori" = 0.25, "*" = 0.75'],
  ["one/expression", { ":pad moods": 1, ":x": 0.2, ":y": -0.5 }, 'pad = "moods", x = 0.2, y = -0.5'],
  ["one/mouth", { ':pad 7"': 1, ":x": 0 }, 'pad = "7\\"", x = 0'],
  ["one/face", { ":pad a=b": 1, ":x": -1, ":y": 0, ":z": 1 }, 'pad = "a=b", x = -1, y = 0, z = 1'],
  ["one/expression", { pad: 0.5, x: 0.5 }, "pad = 0.5, x = 0.5"],
  ["one/face", { 'a "b" = c, d': 1 }, '"a \\"b\\" = c, d" = 1'],
];

it("has the parts of each character together, and those of the scene at the end", () => {
  const parts = ["one/expression", "two/expression", "*/black", "gone/face", "*/light", "two/look", "one/face"];
  const ordered = ["two/expression", "two/look", "one/face", "one/expression", "gone/face", "*/light", "*/black"];
  expect(partsInOrder(parts, ["two", "one"])).toEqual(ordered);
});

describe("goals as text", () => {
  it.each(BOTH)("%s %j is %s, and back", (part, goal, text) => {
    expect(goalText(part, goal)).toBe(text);
    const read = parseGoal(part, text);
    expect(Object.keys(read)).toEqual(Object.keys(goal));
    for (const [name, value] of Object.entries(goal)) expect(read[name]).toBeCloseTo(value, 12);
  });

  it("reads degrees with or without their sign, and leaves what is not written as it was, to the last bit", () => {
    const before = { yaw: 0.3490658503988659, pitch: 0.1234567890123456, roll: -1e-7 };
    expect(goalText("one/head", before)).toBe("yaw = 20°, pitch = 7.1°, roll = 0°");
    expect(parseGoal("one/head", "yaw = 30", before)).toEqual({ ...before, yaw: 30 * (Math.PI / 180) });
    expect(parseGoal("one/head", "yaw = 20°, pitch = 7.1 °, roll = 0", before)).toEqual(before);
    expect(parseGoal("one/gaze", "yaw = 0")).toEqual({ yaw: 0, pitch: 0 });
    expect(goalText("one/place", { x: 0.123456789, depth: 0, size: 1, turn: 0 })).toContain("x = 0.123,");
  });

  it("reads what the text files have too", () => {
    expect(parseGoal("one/expression", "{ joy = 0.7, neutral = 0.3 }")).toEqual({ joy: 0.7, neutral: 0.3 });
    const point = { ":pad moods": 1, ":x": 0.2, ":y": -0.5 };
    expect(parseGoal("one/expression", '{ pad = "moods", x = 0.2, y = -0.5 }')).toEqual(point);
    expect(parseGoal("one/expression", "pad = moods, y = -0.5, x = 0.2")).toEqual(point);
    expect(parseGoal("one/face", '"dog"')).toEqual({ dog: 1 });
    expect(parseGoal("one/face", "my face")).toEqual({ "my face": 1 });
  });

  it("comes back from what it begins with", () => {
    const own = ["head", "gaze", "place", "presence", "motion", "springs", "layer:lips"].map((part) => `one/${part}`);
    for (const part of [...own, "*/black"])
      expect(goalText(part, parseGoal(part, firstGoal(part)))).toBe(firstGoal(part));
  });

  it.each([
    ["one/face", " ", "Give where one/face goes"],
    ["one/head", "0.5", "yaw = 0°, pitch = 0°, roll = 0°"],
    ["one/gaze", "yaw = 45", "yaw goes from -40° to 40°, not to 45°"],
    ["*/black", "black = 1°", '"1°" is no number for black'],
    ["*/black", "dark", "*/black goes to numbers: 1."],
    ["one/expression", "joy = much", '"much" is no number for joy'],
    ["one/mouth", 'pad = "lips"', 'A pad goes to a place: pad = "lips", x = 0.2, y = -0.5.'],
    ["one/mouth", 'pad = "lips", y = 0', "A pad goes to a place"],
    ["one/mouth", 'pad = "lips", x = 0, joy = 1', "A pad goes to a place"],
    ["one/mouth", 'pad = "lips", x = 0, y = 1.2', "y of a pad goes from -1 to 1, not to 1.2"],
    ["*/light", 'pad = "moods", x = 0', '""moods"" is no number for pad'],
    ["one/expression", "joy = 0,7", '"7" is no goal'],
  ])("%s does not go to %s, in words", (part, text, words) => {
    expect(() => parseGoal(part, text)).toThrow(words);
  });
});
