import { expect, it } from "vitest";
import type { Cue, CueListStatus } from "../../link/messages";
import { agoOf, countOf, goesOnWords, movesWords, timeLeft, titleWords } from "./cue_words";

it("counts in tenths, and from a minute on in seconds", () => {
  expect([0, 1.26, 59.9, 59.96, 61.2, 600, -1].map(countOf)).toEqual([
    "0.0",
    "1.3",
    "59.9",
    "1:00",
    "1:01",
    "10:00",
    "0.0",
  ]);
  expect([agoOf(1.26), agoOf(149)]).toEqual(["1.3 s", "2:29"]);
});

it("says what goes on by itself", () => {
  expect(goesOnWords({ goes_on: "", post_wait: 2 })).toBe("");
  expect(goesOnWords({ goes_on: "continue", post_wait: 2 })).toBe("next with it + 2 s");
  expect(goesOnWords({ goes_on: "follow", post_wait: 0 })).toBe("next after it");
});

it("calls a cue without a label by what it moves", () => {
  const move = { goal: {}, seconds: 1, easing: "smooth", delay: 0 };
  const moves = Object.fromEntries(
    ["*/light", "one/face", "one/head", "one/gaze", "*/black"].map((part) => [part, move]),
  );
  expect(titleWords({ label: "Night", moves, actions: [] }, {})).toBe("Night");
  expect(titleWords({ label: "", moves, actions: [] }, { one: "Kaori" })).toBe(
    "light, Kaori face, Kaori head and 2 more",
  );
  expect(titleWords({ label: "", moves: {}, actions: [] }, {})).toBe("moves nothing");
  const clips = {
    "two/clip": { ...move, goal: { monologue: 1, ":start": 2 } },
    "one/clip": move,
  };
  expect(titleWords({ label: "", moves: clips, actions: [] }, { two: "Two" })).toBe(
    "Two clip monologue, one clip stop",
  );
});

it("says the moves of a running order", () => {
  const moves = {
    "kaori/face": { goal: { dog: 1 }, seconds: 2, easing: "smooth", delay: 0.5 },
    "*/light": { goal: { flat: 1 }, seconds: 0, easing: "smooth", delay: 0 },
  };
  expect(movesWords({ moves, actions: [] }, { kaori: "Kaori" })).toBe(
    "Kaori face → dog (2 s after 0.5 s); light → flat (0 s)",
  );
  const point = { ":pad moods": 1, ":x": 0.2, ":y": -0.5 };
  const pad = { "kaori/expression": { goal: point, seconds: 2, easing: "smooth", delay: 0 } };
  expect(movesWords({ moves: pad, actions: [] }, {})).toBe("kaori expression → pad moods at x 0.2, y -0.5 (2 s)");
  const actions = [
    { does: "osc", to: "desk:9000", what: "/go 1", delay: 0.5, voice: "", sound: "" },
    { does: "say", to: "kaori", what: "Good evening.", delay: 0, voice: "de", sound: "" },
  ] as const;
  expect(movesWords({ moves: {}, actions: [...actions] }, { kaori: "Kaori" })).toBe(
    "osc desk:9000 /go 1 after 0.5 s; Kaori: “Good evening.”",
  );
});

it("has a cue end with its last move, also one that waits", () => {
  const name = { identity: "a", number: "2", label: "", note: "", colour: "" };
  const way: CueListStatus = {
    current: name,
    standby: null,
    waits: [{ number: "2", part: "one/face", seconds: 0.5 }],
    moving: [
      { number: "2", part: "one/head", seconds: 1, act: "" },
      { number: "1", part: "*/light", seconds: 9, act: "" },
    ],
    follows: null,
    follows_in: 0,
    since: 1,
    by: "",
    pressed: "GO 2",
  };
  const move = { goal: { dog: 1 }, seconds: 3, easing: "smooth", delay: 1 };
  expect(timeLeft(way, { moves: { "one/face": move } } as unknown as Cue)).toBe(3.5);
  expect(timeLeft({ ...way, waits: [], moving: [] }, null)).toBe(0);
});
