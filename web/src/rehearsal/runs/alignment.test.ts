import { expect, it } from "vitest";
import { commonOf, differencesOf, inWords, onGrid, overA, pairCues, shiftsOf, underA } from "./alignment";

const cue = (number: string, at: number) => ({ at, number, cue_list: "main" });
const A = [cue("1", 10), cue("2", 20), cue("3", 40)];
const B = [cue("1", 15), cue("2", 28), cue("2.5", 30), cue("3", 45)];

it("pairs what both have called, each time it was", () => {
  expect(pairCues(A, B).map(({ number, a, b }) => [number, a, b])).toEqual([
    ["1", 10, 15],
    ["2", 20, 28],
    ["2.5", undefined, 30],
    ["3", 40, 45],
  ]);
  const twice = pairCues([cue("1", 1), cue("1", 5)], [cue("1", 2)]);
  expect(twice.map(({ a, b }) => [a, b])).toEqual([
    [1, 2],
    [5, undefined],
  ]);
  expect(pairCues([], [cue("7", 3)])).toHaveLength(1);
});

it("leaves a pair out of the common ones that goes back in time", () => {
  const pairs = pairCues([cue("1", 10), cue("2", 20)], [cue("2", 5), cue("1", 30)]);
  expect(commonOf(pairs)).toEqual([{ a: 10, b: 30 }]);
});

it("lets each stretch begin together, and leaves out what is longer in B", () => {
  const shifts = shiftsOf(pairCues(A, B), "cues");
  expect(overA(shifts, 5)).toBe(0); // before the first cue
  expect([15, 28, 45].map((at) => overA(shifts, at))).toEqual([10, 20, 40]);
  expect(overA(shifts, 24.9)).toBeCloseTo(19.9);
  expect(overA(shifts, 26)).toBeUndefined(); // 13 s where A took 10
  expect(underA(shifts, 38)).toBeUndefined(); // 17 s where A took 20
  for (const at of [0, 15, 20, 28, 44, 45, 90]) {
    const over = overA(shifts, at);
    if (over !== undefined) expect(underA(shifts, over)).toBeCloseTo(at);
  }
});

it("is moved as a whole by the start or by a moment", () => {
  const pairs = pairCues(A, B);
  expect(overA(shiftsOf(pairs, "start"), 12)).toBe(12);
  expect(overA(shiftsOf(pairs, { a: 20, b: 28 }), 45)).toBe(37);
  expect(overA(shiftsOf([], "cues"), 12)).toBe(12);
});

it("says how much later a cue came", () => {
  const late = (anchor: Parameters<typeof differencesOf>[1]) =>
    differencesOf(pairCues(A, B), anchor).map(({ late, longer }) => [late, longer]);
  expect(late("cues")).toEqual([
    [0, undefined],
    [3, 3],
    [undefined, undefined],
    [0, -3],
  ]);
  expect(late("start")).toEqual([
    [5, undefined],
    [8, 3],
    [undefined, undefined],
    [5, -3],
  ]);
  expect([1.44, -0.6, 0.04].map(inWords)).toEqual(["1.4 s later", "0.6 s earlier", "together"]);
});

it("puts samples on a grid, and leaves gaps that are none", () => {
  expect(onGrid([0, 0.11, 0.29, 0.6], [1, 2, 3, 4], 0, 8)).toEqual([1, 2, 2, 3, null, null, 4, null]);
});
