/** What was recorded, asked of the show or of a replay; what cannot be done is an Error with a sentence. */

import { decode } from "@msgpack/msgpack";
import type { MarkedMoment, MarkerRequest, RecordedSpan, RecordingsDocument, RunDocument } from "../link/messages";

/** A note of a director: a moment that was marked, with words. */
export type Note = MarkedMoment;

/** A run that can be looked at: what was recorded without a break, or what is kept under a name. */
export interface Run extends RecordedSpan {
  /** Of which file. */
  file: number;
}

const MISSING = "This show is not recorded, so there is nothing to look at: start it without --no-record.";
const GONE = "The show does not answer: it has ended, or the network is gone.";

/** Who asks, of the network; another in tests. */
export type Ask = (path: string, request?: RequestInit) => Promise<Response>;

async function ask(path: string, request?: RequestInit, by: Ask = fetch): Promise<Response> {
  let answer: Response;
  try {
    answer = await by(path, { cache: "no-store", ...request });
  } catch {
    throw new Error(GONE);
  }
  if (answer.ok) return answer;
  throw new Error((await answer.text()) || `The show answers ${answer.status}.`);
}

/** What is recorded of a file. */
export async function readRecordings(file = 0, by?: Ask): Promise<RecordingsDocument> {
  const answer = await ask(`/recordings?file=${file}`, undefined, by);
  if (answer.status === 204) throw new Error(MISSING);
  return (await answer.json()) as RecordingsDocument;
}

/** The curves and cues of a run. */
export async function readRun({ file, start, first, seconds }: Run, by?: Ask): Promise<RunDocument> {
  const asked = new URLSearchParams({
    file: String(file),
    start: String(start),
    first: String(first),
    last: String(first + seconds),
  });
  return decode(await (await ask(`/curves?${asked}`, undefined, by)).arrayBuffer()) as RunDocument;
}

/** Writes a note: a new one, or other words of the one of an id. */
export async function writeNote(note: Partial<MarkerRequest>, id?: number, by?: Ask): Promise<void> {
  await ask(id === undefined ? "/markers" : `/markers/${id}`, { method: "POST", body: JSON.stringify(note) }, by);
}

export async function deleteNote(id: number, by?: Ask): Promise<void> {
  await ask(`/markers/${id}`, { method: "DELETE" }, by);
}

/** Plays a replay from a moment on, and holds it there; `at`: seconds of the clock of a start of the show. */
export async function seekReplay(start: number, at: number, by?: Ask): Promise<void> {
  await ask("/replay/transport", { method: "POST", body: JSON.stringify({ start, at }) }, by);
}

/** The runs of a file, the newest first. */
export const runsOf = ({ spans, kept }: RecordingsDocument, file: number): Run[] =>
  [...kept, ...[...spans].reverse()].map((span) => ({ ...span, file }));

/** Seconds from the beginning of its start of the show to a note. */
export function sinceBegin(
  { spans }: Pick<RecordingsDocument, "spans">,
  { start, at }: Pick<Note, "start" | "at">,
): number {
  const begin = spans.find((span) => span.start === start);
  return begin === undefined ? 0 : at - begin.first;
}

/** A day and a time of day, as people write them here. */
export const dayOf = (written: number): string =>
  new Date(written * 1000).toLocaleString([], {
    weekday: "short",
    day: "numeric",
    month: "short",
    hour: "2-digit",
    minute: "2-digit",
    hour12: false,
  });
