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
 * kept of another one. Of one start alone two that are kept are compared: the whole has each in it.
 */
export function choicesOf(documents: readonly RecordingsDocument[]): Choices {
  const runs = documents.flatMap(runsOf);
  const newest = (file: number, but = -1): number =>
    runs.findIndex((run, place) => run.file === file && run.name === "" && place !== but);
  const b = Math.max(newest(0), 0);
  const other = documents.length > 1 ? newest(1) : newest(0, b);
  if (other >= 0) return { runs, a: other, b };
  const kept = runs.flatMap(({ name }, place) => (name === "" ? [] : [place]));
  const elsewhere = kept.find((place) => runs[place]?.start !== runs[b]?.start);
  const [one, two] = [...kept].sort((first, second) => (runs[second]?.first ?? 0) - (runs[first]?.first ?? 0));
  if (elsewhere !== undefined) return { runs, a: elsewhere, b };
  return one === undefined || two === undefined ? { runs, a: one ?? 0, b } : { runs, a: two, b: one };
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
