import { expect, it } from "vitest";
import { type KnownNames, missingInCue, missingInMove } from "./missing_names";

const KNOWN: KnownNames = {
  face: new Set(["dog"]),
  expression: new Set(["joy", "neutral"]),
  light: new Set(["flat"]),
  clip: new Set(["line1"]),
  character: new Set(["one", "two"]),
  "gaze point": new Set(["seat"]),
  pad: new Set(["moods"]),
};

it.each([
  ["one/face", ["dog"], []],
  ["one/face", ["dgo", "dog"], ["no face dgo"]],
  ["gone/face", ["dog"], ["no character gone"]],
  ["one/brows", ["joy", "rage"], ["no expression rage"]],
  ["one/brows", [], []],
  ["*/light", ["dusk"], ["no light dusk"]],
  ["*/framing", ["*"], []],
  ["*/framing", ["one+gone"], ["no character gone"]],
  ["*/framing", ["one:full"], []],
  ["one/head", ["yaw", "pitch", "roll"], []],
  ["one/look", ["character two"], []],
  ["one/look", ["character gone"], ["no character gone"]],
  ["one/look", ["gaze_point door"], ["no gaze point door"]],
  ["one/look", ["stage left"], []],
  ["one/layer:tracker", ["brows"], []],
  ["*/black", ["black"], []],
  ["one/clip", ["line1", ":start"], []],
  ["one/clip", ["line2", ":start"], ["no clip line2"]],
  ["one/clip", [], []],
  ["one/expression", [":pad moods", ":x", ":y"], []],
  ["one/face", [":pad faces", ":x", ":y"], ["no pad faces"]],
  ["gone/mouth", [":pad lips", ":x"], ["no character gone", "no pad lips"]],
])("%s to %j lacks %j", (part, names, missing) => {
  expect(missingInMove(part, Object.fromEntries(names.map((name) => [name, 1])), KNOWN)).toEqual(missing);
});

it("says each thing of a cue once", () => {
  const move = { seconds: 1, easing: "smooth", delay: 0 };
  const moves = { "gone/face": { goal: { dgo: 1 }, ...move }, "gone/head": { goal: { yaw: 0 }, ...move } };
  const say = { does: "say", to: "nobody", what: "Ho", delay: 0, voice: "", sound: "" } as const;
  expect(missingInCue({ moves, actions: [say, { ...say, to: "*" }] }, KNOWN)).toEqual([
    "no character gone",
    "no face dgo",
    "no character nobody",
  ]);
});
