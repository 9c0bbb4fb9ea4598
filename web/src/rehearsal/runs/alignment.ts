/** How two runs lie over one another: A where it was, B moved so that a moment of both is one. Times in seconds. */

import type { CalledCue } from "../../link/messages";

/** A cue that A, B or both have called: when, in each. */
export interface CuePair {
  list: string;
  number: string;
  a: number | undefined;
  b: number | undefined;
}

/** What of B is moved by how much: `from` (with it) `to` (without it). */
export interface Shift {
  from: number;
  to: number;
  by: number;
}

/** By which moment: each common cue, the beginning, or one moment of each. */
export type Anchor = "cues" | "start" | { a: number; b: number };

/** The cues of both; one that was called twice is two. In the order of A, those of B alone behind the one before. */
export function pairCues(a: readonly CalledCue[], b: readonly CalledCue[]): CuePair[] {
  const pairs: CuePair[] = keyed(a).map(([, cue]) => ({
    list: cue.cue_list,
    number: cue.number,
    a: cue.at,
    b: undefined,
  }));
  const places = new Map(keyed(a).map(([key], place) => [key, pairs[place]]));
  let before: CuePair | undefined;
  for (const [key, cue] of keyed(b)) {
    const there = places.get(key);
    const pair = there ?? { list: cue.cue_list, number: cue.number, a: undefined, b: cue.at };
    pair.b = cue.at;
    if (there === undefined) pairs.splice(before === undefined ? 0 : pairs.indexOf(before) + 1, 0, pair);
    before = pair;
  }
  return pairs;
}

function keyed(cues: readonly CalledCue[]): [string, CalledCue][] {
  const times = new Map<string, number>();
  return cues.map((cue) => {
    const name = JSON.stringify([cue.cue_list, cue.number]);
    const count = (times.get(name) ?? 0) + 1;
    times.set(name, count);
    return [`${name} ${count}`, cue];
  });
}

/** The pairs that both have called, in one order. */
export function commonOf(pairs: readonly CuePair[]): { a: number; b: number }[] {
  const common: { a: number; b: number }[] = [];
  for (const { a, b } of pairs) {
    const last = common.at(-1);
    if (a !== undefined && b !== undefined && (last === undefined || (a > last.a && b > last.b))) common.push({ a, b });
  }
  return common;
}

/**
 * How B is moved. By common cues each stretch begins together: where B's lasted longer its end is left out, where it was
 * shorter there is a gap.
 */
export function shiftsOf(pairs: readonly CuePair[], anchor: Anchor): Shift[] {
  const whole = (by: number): Shift[] => [{ from: -Infinity, to: Infinity, by }];
  if (anchor === "start") return whole(0);
  if (anchor !== "cues") return whole(anchor.a - anchor.b);
  const common = commonOf(pairs);
  const [first] = common;
  if (first === undefined) return whole(0);
  const stretches = common.map(({ a, b }, place) => {
    const next = common[place + 1];
    const to = next === undefined ? Infinity : Math.min(next.b, b + next.a - a);
    return { from: b, to, by: a - b };
  });
  return [{ from: -Infinity, to: first.b, by: first.a - first.b }, ...stretches];
}

/** Where a time of B lies over A; undefined where it is left out. */
export const overA = (shifts: readonly Shift[], b: number): number | undefined => {
  const shift = shifts.find(({ from, to }) => b >= from && b < to);
  return shift && b + shift.by;
};

/** Which time of B lies over a time of A; undefined where none does. */
export const underA = (shifts: readonly Shift[], a: number): number | undefined => {
  const shift = shifts.find(({ from, to, by }) => a - by >= from && a - by < to);
  return shift && a - shift.by;
};

/** A cue with how much later B called it than A: `late` since the moment by which they are laid over one another,
 * `longer` since the common cue before. */
export interface Difference extends CuePair {
  late: number | undefined;
  longer: number | undefined;
}

export function differencesOf(pairs: readonly CuePair[], anchor: Anchor): Difference[] {
  const [first] = commonOf(pairs);
  const origin = anchor === "cues" ? (first ?? { a: 0, b: 0 }) : anchor === "start" ? { a: 0, b: 0 } : anchor;
  let before: { a: number; b: number } | undefined;
  return pairs.map((pair) => {
    const { a, b } = pair;
    if (a === undefined || b === undefined) return { ...pair, late: undefined, longer: undefined };
    const late = b - origin.b - (a - origin.a);
    const longer = before && b - before.b - (a - before.a);
    before = { a, b };
    return { ...pair, late, longer };
  });
}

/** How much later, in words: `1.4 s later`. */
export function inWords(seconds: number): string {
  const rounded = Math.round(Math.abs(seconds) * 10) / 10;
  if (rounded === 0) return "together";
  return `${rounded.toFixed(1)} s ${seconds > 0 ? "later" : "earlier"}`;
}

/** Samples a second of the charts. */
export const GRID = 10;

/** Puts values at times on a grid from `first` on; null where nothing is. `moved`: where a time lies. */
export function onGrid<Value>(
  times: readonly number[],
  values: readonly (Value | null)[],
  first: number,
  length: number,
  moved: (time: number) => number | undefined = (time) => time,
): (Value | null)[] {
  const grid = new Array<Value | null>(length).fill(null);
  times.forEach((time, row) => {
    const at = moved(time);
    const place = at === undefined ? -1 : Math.round((at - first) * GRID);
    if (place >= 0 && place < length) grid[place] = values[row] ?? null;
  });
  return fillGaps(grid);
}

/** One place without a sample between two that have one is no gap: samples come 0.1 s apart, and not quite. */
function fillGaps<Value>(grid: (Value | null)[]): (Value | null)[] {
  for (let place = 1; place + 1 < grid.length; place++)
    if (grid[place] === null && grid[place + 1] !== null) grid[place] = grid[place - 1] ?? null;
  return grid;
}
