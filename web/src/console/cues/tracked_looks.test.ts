import { expect, it } from "vitest";
import type { Cue, PadState } from "../../link/messages";
import type { Goal } from "./goal_text";
import { lookOf, shownCharacter, trackedLooks } from "./tracked_looks";

const cue = (moves: Record<string, Goal>, skip = false): Pick<Cue, "moves" | "skip"> => ({
  moves: Object.fromEntries(
    Object.entries(moves).map(([part, goal]) => [part, { goal, seconds: 1, easing: "smooth", delay: 0 }]),
  ),
  skip,
});
const JOY = { joy: 1 };
const FEAR = { fear: 1 };

it("tracks what no cue moves again, and a whole expression takes its own regions with it", () => {
  const looks = trackedLooks([
    cue({ "one/face": { dog: 1 }, "one/brows": FEAR, "two/brows": FEAR }),
    cue({ "one/expression": JOY }),
    cue({ "one/expression": FEAR, "one/mouth": JOY }),
  ]);
  expect(looks[1]).toEqual({ "one/face": { dog: 1 }, "two/brows": FEAR, "one/expression": JOY });
  expect(looks[2]).toEqual({ "one/face": { dog: 1 }, "two/brows": FEAR, "one/expression": FEAR, "one/mouth": JOY });
});

it("has nothing of a cue that is skipped stand behind it", () => {
  const looks = trackedLooks([cue({ "one/face": { dog: 1 } }, true), cue({ "one/expression": JOY })]);
  expect(looks).toEqual([{ "one/face": { dog: 1 } }, { "one/expression": JOY }]);
});

it("shows whom a cue moves, as most of the face and of the expression is", () => {
  const moved = cue({ "*/light": { flat: 1 }, "kaori/head": {}, "ben/face": { dog: 0.2, cat: 0.8 } });
  expect(shownCharacter(moved)).toBe("ben");
  expect(shownCharacter(cue({ "*/black": { black: 1 } }))).toBeNull();
  const [look] = trackedLooks([moved]);
  expect(lookOf(look ?? {}, "ben", "generic", [])).toEqual({ face: "cat", expression: "neutral" });
  expect(lookOf(look ?? {}, "kaori", "generic", [])).toEqual({ face: "generic", expression: "neutral" });
});

it("shows what weighs most at a point of a pad, and what is at home where there is no such pad or place", () => {
  const look = (mix: Record<string, number>, ...place: number[]) => ({ label: "", mix, place });
  const looks = [
    look({ neutral: 1 }, 0, 0),
    look({ joy: 0.5, fear: 0.5 }, 1, 0),
    look({ joy: 0.5, rage: 0.5 }, 0.9, 0.3),
  ];
  const moods: PadState = { name: "moods", part: "expression", dimensions: 2, looks, missing: [] };
  const shown = (goal: Goal) => lookOf({ "ben/expression": goal }, "ben", "generic", [moods]).expression;
  expect(shown({ ":pad moods": 1, ":x": 0.1, ":y": 0 })).toBe("neutral");
  expect(shown({ ":pad moods": 1, ":x": 0.95, ":y": 0.15 })).toBe("joy");
  expect(shown({ ":pad moods": 1, ":x": 1 })).toBe("neutral");
  expect(shown({ ":pad gone": 1, ":x": 0.95, ":y": 0.15 })).toBe("neutral");
});
