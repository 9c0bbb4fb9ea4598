import { expect, it } from "vitest";
import { readRecordings, runsOf, sinceBegin, writeNote } from "./recordings";

const span = (start: number, first: number, name = "") => ({ start, first, written: 0, seconds: 10, name });
const answering = (status: number, body: string | null) => async () => new Response(body, { status });

it("says in words what the show refuses, and where there is no recording or no show", async () => {
  await expect(writeNote({ name: "x" }, undefined, answering(400, "No."))).rejects.toThrow("No.");
  await expect(readRecordings(0, answering(204, null))).rejects.toThrow("not recorded");
  const dead = async () => Promise.reject(new TypeError("no network"));
  await expect(readRecordings(0, dead)).rejects.toThrow("does not answer");
});

it("lists what is kept, then the newest first; times are from the beginning of the show", () => {
  const document = { spans: [span(1, 5), span(2, 100), span(2, 130)], kept: [span(1, 6, "best")] };
  const runs = runsOf({ ...document, markers: [], files: [], name: "", role: "view", now: null, cue: "" }, 1);
  expect(runs.map(({ name, first, file }) => [name, first, file])).toEqual([
    ["best", 6, 1],
    ["", 130, 1],
    ["", 100, 1],
    ["", 5, 1],
  ]);
  expect(sinceBegin(document, { start: 2, at: 135 })).toBe(35);
});
