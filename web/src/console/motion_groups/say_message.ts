/** A line as a message, and what is said in words. */

import type { Say, SpeechState } from "../../link/messages";
import type { Asked } from "../store/file_requests";

/** A line as a message: letters timed by rule, no sound of the stage. */
export const sayMessage = (character: string, text: string, language: Say["language"]): Asked => ({
  type: "say",
  character,
  text,
  timing: "text",
  marks: [],
  times: new Uint8Array(),
  language,
  seconds: null,
  sound: "",
  delay: 0,
  offset: 0,
  queue: false,
  key: "",
});

/** What is said now, in words. */
export function speechWords(speech: SpeechState | null): string {
  if (speech === null) return "Says nothing";
  const waiting = speech.waiting === 0 ? "" : `, ${speech.waiting} waiting`;
  const time = `${Math.max(speech.elapsed, 0).toFixed(1)} of ${speech.seconds.toFixed(1)} s`;
  return `${speech.text === "" ? "Speaks" : speech.text}: ${time}${speech.sound === "" ? "" : ", with sound"}${waiting}`;
}
