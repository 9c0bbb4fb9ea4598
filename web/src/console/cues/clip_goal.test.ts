import { expect, it } from "vitest";
import { type ClipCall, clipCallOf, clipWords, goalOfClip, withPart } from "./clip_goal";
import type { Goal } from "./goal_text";

const PLAIN: ClipCall = { clip: "line 1", start: 0, speed: null, loop: null, weights: null };
const ALL: readonly (readonly [Goal, ClipCall, string])[] = [
  [{ "line 1": 1 }, PLAIN, "line 1"],
  [{ "line 1": 1, ":start": 12.4 }, { ...PLAIN, start: 12.4 }, "line 1 from 12.4 s"],
  [{ "line 1": 1, ":speed": 0.5, ":loop": 0 }, { ...PLAIN, speed: 0.5, loop: false }, "line 1, speed 0.5, once"],
  [
    { "line 1": 1, ":loop": 1, ":mouth": 1, ":head": 0.5 },
    { ...PLAIN, loop: true, weights: { mouth: 1, head: 0.5 } },
    "line 1, again and again, mouth head 0.5",
  ],
  [{ ":start": 1 }, { ...PLAIN, clip: ":start" }, ":start"],
];

it.each(ALL)("%j is a call, and back, in words", (goal, call, words) => {
  expect(clipCallOf(goal)).toEqual(call);
  expect(goalOfClip(call)).toEqual(goal);
  expect(clipWords(call)).toBe(words);
});

it("calls nothing where clips stop", () => {
  expect(clipCallOf({})).toBeNull();
});

it("takes parts out and in, and has one at least", () => {
  const without = withPart(PLAIN, "mouth", false);
  expect(without?.weights).toEqual({ brows: 1, eyes: 1, rest: 1, head: 1, gaze: 1 });
  expect(goalOfClip(withPart(without as ClipCall, "mouth", true) as ClipCall)).toEqual({ "line 1": 1 });
  const half: ClipCall = { ...PLAIN, weights: { mouth: 0.5 } };
  expect(withPart(half, "head", true)?.weights).toEqual({ mouth: 0.5, head: 1 });
  expect(withPart(half, "mouth", false)).toBeNull();
});
