/** Which runs there are to choose from, and which quantities are drawn. */

import type { RecordingsDocument } from "../../link/messages";
import { sinceOf } from "../../ui/show_times";
import { dayOf, type Run, runsOf } from "../recordings";

/** All runs of all files, and which two are compared first. */
export interface Choices {
  runs: Run[];
  a: number;
  b: number;
}

/**
 * B is the newest start; A what it is held against: the newest of the other file, else the start before, else what is
 * kept of another one. Of a start with one kept run that is taken, not the whole, which has warming up in it. Of one
 * start alone two that are kept are compared, or the one with the rest of it.
 */
export function choicesOf(documents: readonly RecordingsDocument[]): Choices {
  const runs = documents.flatMap(runsOf);
  const newest = (file: number, but = -1): number =>
    runs.findIndex((run, place) => run.file === file && run.name === "" && place !== but);
  const whole = Math.max(newest(0), 0);
  const other = documents.length > 1 ? newest(1) : newest(0, whole);
  const keptOf = (place: number): number[] => {
    const { start, file } = runs[place] ?? {};
    const places = runs.flatMap((run, at) => (run.name !== "" && run.start === start && run.file === file ? [at] : []));
    return places.sort((one, two) => (runs[two]?.first ?? 0) - (runs[one]?.first ?? 0));
  };
  const chosen = (place: number): number => {
    const [one = place, ...more] = keptOf(place);
    return more.length === 0 ? one : place;
  };
  if (other >= 0) return { runs, a: chosen(other), b: chosen(whole) };
  const elsewhere = runs.findIndex(({ name, start }) => name !== "" && start !== runs[whole]?.start);
  if (elsewhere >= 0) return { runs, a: elsewhere, b: chosen(whole) };
  const [one, two] = keptOf(whole);
  if (one === undefined) return { runs, a: 0, b: whole };
  if (two !== undefined) return { runs, a: two, b: one };
  const rest = restOf(runs[whole] as Run, runs[one] as Run);
  return rest === undefined ? { runs, a: one, b: whole } : { runs: [...runs, rest], a: one, b: runs.length };
}

/** What a start has beside the run that is kept of it: the longer of what came after it and before; of none nothing. */
function restOf(whole: Run, kept: Run): Run | undefined {
  const end = kept.first + kept.seconds;
  const before = kept.first - whole.first;
  const after = whole.first + whole.seconds - end;
  if (Math.max(before, after) <= 0) return undefined;
  if (before > after) return { ...whole, seconds: before, name: `before ${kept.name}` };
  return {
    ...whole,
    first: end,
    seconds: after,
    written: whole.written + end - whole.first,
    name: `after ${kept.name}`,
  };
}

/** A run in words: `evening · Mon 30 Nov, 20:15 · 1:32:10`. */
export function nameOf(run: Run, files: readonly string[]): string {
  const file = files.length > 1 ? files[run.file] : "";
  return [file, run.name, dayOf(run.written), sinceOf(run.seconds)].filter((word) => word).join(" · ");
}

export interface Quantity {
  key: string;
  label: string;
  unit: string;
  /** Which names stand beside its values. */
  words?: "face" | "expression";
}

export const QUANTITIES: readonly Quantity[] = [
  { key: "expression", label: "Expression", unit: "", words: "expression" },
  { key: "face", label: "Face", unit: "", words: "face" },
  { key: "brows", label: "Brows", unit: "" },
  { key: "eyes", label: "Eyes", unit: "" },
  { key: "mouth", label: "Mouth", unit: "" },
  { key: "rest", label: "Rest", unit: "" },
  { key: "head_yaw", label: "Head turn", unit: "°" },
  { key: "head_pitch", label: "Head nod", unit: "°" },
  { key: "head_roll", label: "Head tilt", unit: "°" },
  { key: "gaze_yaw", label: "Gaze across", unit: "°" },
  { key: "gaze_pitch", label: "Gaze up", unit: "°" },
  { key: "x", label: "Place across", unit: " m" },
  { key: "depth", label: "Place behind", unit: " m" },
  { key: "presence", label: "On stage", unit: "" },
  { key: "speaking", label: "Speaking", unit: "" },
];
export const FIRST_SHOWN = ["expression", "mouth", "head_yaw"];
