import { expect, it } from "vitest";
import { notesAsTable, notesAsText, type TimedNote } from "./note_texts";

const note = (name: string, more: Partial<TimedNote> = {}): TimedNote => ({
  id: 1,
  start: 1,
  at: 100,
  written: new Date(2026, 10, 30, 20, 15, 5).getTime() / 1000,
  name,
  who: "dora",
  cue: "12",
  since: 65,
  ...more,
});

it("writes a line for each note", () => {
  expect(notesAsText([note("too late"), note("louder", { cue: "", who: "" })])).toBe(
    "20:15:05  0:01:05  cue 12  too late  (dora)\n20:15:05  0:01:05  louder\n",
  );
});

it("writes a table that a spreadsheet reads as it was said", () => {
  const rows = notesAsTable([note('say "no", then go'), note("=1+1")]).split("\n");
  expect(rows).toEqual([
    "day,seconds,cue,who,note",
    '2026-11-30 20:15:05,65.0,12,dora,"say ""no"", then go"',
    "2026-11-30 20:15:05,65.0,12,dora,'=1+1",
    "",
  ]);
});
