/** The passes that are recorded anywhere in the show, and what is said of them. */

import { CLIP_PARTS } from "../../link/constants";
import type { ClipPass } from "../../link/messages";
import type { ConsoleStore } from "../store/console_store";

/** All passes that are recorded now. */
export const passesOf = (show: ConsoleStore): readonly ClipPass[] => show.newest("clip_work")?.passes ?? [];

const withoutNumber = (name: string): string => name.replace(/(?<=\S) \d+$/, "");

/**
 * The pass that the hand at a console ends by a key: of a character that it plays, recorded by a page of the same name
 * ("Anna 2" is another page of Anna's). `name`: of the console; `played`: its characters.
 */
export const ownPass = (passes: readonly ClipPass[], name: string, played: readonly string[]): ClipPass | undefined =>
  passes.find(({ by, character }) => withoutNumber(by) === withoutNumber(name) && played.includes(character));

/** Ends a pass, and says how. */
export function endPass(show: ConsoleStore, { character, lane, name }: ClipPass, keep: boolean): void {
  show.ask({ type: "keep_pass", character, keep });
  show.say(keep ? `Kept in ${name}: lane ${lane}.` : "The pass is discarded.", "done");
}

/** The speeds at which the page of clips records, seconds of the clip a second. */
export const PASS_SPEEDS = [1, 0.75, 0.5, 0.25] as const;
const SPEED_WORDS: Readonly<Record<number, string>> = { 1: "", 0.75: " at three quarter speed", 0.5: " at half speed" };

/** A speed as it is said behind what is recorded; "" for the full one. */
const speedWords = (speed: number): string => SPEED_WORDS[speed] ?? ` at ${Math.round(speed * 100)} % of its speed`;

/** Where in the time of its clip a pass is; `time`: of the show. */
export const positionOf = (pass: Pick<ClipPass, "began" | "start" | "speed">, time: number): number =>
  pass.start + Math.max(0, time - pass.began) * pass.speed;

/** Minutes, seconds and tenths: `1:04.2`. */
export function clipTime(seconds: number): string {
  const tenths = Math.round(Math.abs(seconds) * 10);
  const [minutes, rest] = [Math.floor(tenths / 600), (tenths % 600) / 10];
  return `${seconds < 0 && tenths > 0 ? "−" : ""}${minutes}:${rest.toFixed(1).padStart(4, "0")}`;
}

/** What parts are called together; `all`: how many there are. */
export const partsLabel = (parts: readonly string[], all: number): string =>
  parts.length === all ? "all parts" : parts.join(", ");

/** Who records what of whom; `label`: of the character. */
export const passWords = ({ by, parts, name, speed }: ClipPass, label: string, all: number): string =>
  `${by === "" ? "A program" : by} records ${partsLabel(parts, all)} of ${label} in ${name}${speedWords(speed)}`;

/** The same where there is little room: what is last is cut first. */
export const lightWords = ({ by, parts, name, speed }: ClipPass, label: string, all: number): string =>
  `${partsLabel(parts, all)} of ${label}, ${name}${speedWords(speed)}${by === "" ? "" : ` · ${by}`}`;

/** What a pass gives its clip, as people read it. */
export const passLabel = ({ parts, lane }: Pick<ClipPass, "parts" | "lane">): string =>
  `${partsLabel(parts, CLIP_PARTS.length)}${lane === "" ? "" : `, lane ${lane},`}`;

/** Seconds after which a pass ends by itself, but for the moment until that is heard. */
const LONGEST_PASS = 599;

/** What is said of a pass that this page has not ended; `time`: of the show. */
export function endedWords(pass: ClipPass, kept: boolean, time: number): string {
  const why = time - pass.began >= LONGEST_PASS ? "it ended by itself after ten minutes" : "another hand ended it";
  return kept
    ? `Kept in ${pass.name}: ${passLabel(pass)} is a lane now; ${why}.`
    : `The pass of ${passLabel(pass)} is not kept; ${why}.`;
}
