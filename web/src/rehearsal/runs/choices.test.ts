import { expect, it } from "vitest";
import { choicesOf } from "./choices";

const span = (start: number, name = "") => ({ start, first: 0, written: 0, seconds: 10, name });
const document = (starts: number[], kept: string[] = []) => ({
  spans: starts.map((start) => span(start)),
  kept: kept.map((name) => span(1, name)),
  markers: [],
  files: [],
  name: "",
  role: "view" as const,
  now: null,
  cue: "",
});
const chosen = (...documents: ReturnType<typeof document>[]) => {
  const { runs, a, b } = choicesOf(documents);
  return [runs[a], runs[b]].map((run) => run && [run.file, run.start, run.name]);
};

it("holds the newest against the one before, else against what is kept, or another file", () => {
  expect(chosen(document([1, 2, 3]))).toEqual([
    [0, 2, ""],
    [0, 3, ""],
  ]);
  expect(chosen(document([3], ["best"]))).toEqual([
    [0, 1, "best"],
    [0, 3, ""],
  ]);
  expect(chosen(document([1, 2]), document([7, 8]))).toEqual([
    [1, 8, ""],
    [0, 2, ""],
  ]);
  expect(chosen(document([1]))).toEqual([
    [0, 1, ""],
    [0, 1, ""],
  ]);
  expect(chosen(document([]))).toEqual([undefined, undefined]);
  const twice = document([1], ["first", "second"]);
  twice.kept[1] = { ...span(1, "second"), first: 5 };
  expect(chosen(twice)).toEqual([
    [0, 1, "first"],
    [0, 1, "second"],
  ]);
});
