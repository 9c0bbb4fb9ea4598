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
  expect(chosen(document([1, 2], ["dress"]))).toEqual([
    [0, 1, "dress"],
    [0, 2, ""],
  ]);
  const twice = document([1], ["first", "second"]);
  twice.kept[1] = { ...span(1, "second"), first: 5 };
  expect(chosen(twice)).toEqual([
    [0, 1, "first"],
    [0, 1, "second"],
  ]);
});

it("holds the one run that is kept of a start alone against the rest of it", () => {
  const once = document([1], ["first"]);
  once.kept[0] = { ...span(1, "first"), first: 1, seconds: 4 };
  const { runs, a, b } = choicesOf([once]);
  expect(runs[a]?.name).toBe("first");
  expect(runs[b]).toEqual({ ...span(1, "after first"), first: 5, seconds: 5, written: 5, file: 0 });
  once.kept[0] = { ...span(1, "first"), first: 6, seconds: 4 };
  const late = choicesOf([once]);
  expect(late.runs[late.b]).toEqual({ ...span(1, "before first"), seconds: 6, file: 0 });
  once.kept[0] = span(1, "first");
  expect(chosen(once)).toEqual([
    [0, 1, "first"],
    [0, 1, ""],
  ]);
});
