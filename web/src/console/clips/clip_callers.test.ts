import { expect, it } from "vitest";
import { findCallers } from "./clip_callers";

it("finds the cues of all lists that call a clip, and leaves out a list that cannot be read", async () => {
  const cue = (number: string, part: string, goal: object) => ({ number, moves: { [part]: { goal } } });
  const lists: Record<string, object[]> = {
    main: [cue("1", "one/clip", { line: 1, ":start": 2 }), cue("2", "one/expression", { line: 1 })],
    second: [cue("7", "*/clip", { line: 1 }), cue("8", "*/clip", { other: 1 })],
  };
  const request = async (address: string) => {
    const cues = lists[address.replace("/cue_lists/", "")];
    if (cues === undefined) throw new TypeError("no answer");
    return { status: 200, json: async () => ({ cues }) };
  };
  const found = (...names: string[]) => findCallers("line", names, request as unknown as typeof fetch);
  expect(await found("main")).toEqual(["cue 1"]);
  expect(await found("main", "second", "lost")).toEqual(["cue 1 of main", "cue 7 of second"]);
});
