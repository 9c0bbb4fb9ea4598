/** Notes as texts that leave the page: to read, and as a table. */

import { clockOf, sinceOf } from "../ui/show_times";
import type { Note } from "./recordings";

/** A note with the seconds from the beginning of its show. */
export interface TimedNote extends Note {
  since: number;
}

const timeOf = ({ written }: Note): string => clockOf(new Date(written * 1000));

/** A line for each note: when, in which cue, what, of whom. */
export const notesAsText = (notes: readonly TimedNote[]): string =>
  notes
    .map((note) => {
      const cue = note.cue === "" ? "" : `  cue ${note.cue}`;
      const who = note.who === "" ? "" : `  (${note.who})`;
      return `${timeOf(note)}  ${sinceOf(note.since)}${cue}  ${note.name}${who}\n`;
    })
    .join("");

/** A field of a table. A leading sign is no formula: a spreadsheet would calculate it. */
function field(text: string): string {
  const plain = /^[=+\-@\t\r]/.test(text) ? `'${text}` : text;
  return /[",\n\r]/.test(plain) ? `"${plain.replaceAll('"', '""')}"` : plain;
}

/** A table (CSV) with a row for each note. */
export const notesAsTable = (notes: readonly TimedNote[]): string =>
  [["day", "seconds", "cue", "who", "note"], ...notes.map(rowOf)]
    .map((row) => `${row.map(field).join(",")}\n`)
    .join("");

const rowOf = (note: TimedNote): string[] => {
  const day = new Date(note.written * 1000);
  const local = new Date(day.getTime() - day.getTimezoneOffset() * 60_000).toISOString().slice(0, 19);
  return [local.replace("T", " "), note.since.toFixed(1), note.cue ?? "", note.who, note.name];
};
