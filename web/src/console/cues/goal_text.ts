/** Goals of cues as people write them: as in the text files of docs/howto/cues.md, without their outer brackets. */

import { LAYER_PARTS, LAYERS, PLAY_REGIONS } from "../../link/constants";
import { clipCallOf, clipWords } from "./clip_goal";

export type Goal = Readonly<Record<string, number>>;

/** The parts of a character, and of the scene, that a cue can move, in the order of the form. */
export const CHARACTER_PARTS = [
  "face",
  "expression",
  ...PLAY_REGIONS,
  "head",
  "gaze",
  "place",
  "presence",
  "motion",
  "look",
  ...LAYERS.map((layer) => `layer:${layer}`),
  "clip",
];
export const SCENE_PARTS = ["light", "framing", "black"] as const;

/** How the text says that a region goes with the whole face. */
const WITH_FACE = "face";
/** How it says that clips stop. */
const STOP = "stop";

/** What a goal of each part that is numbers looks like. */
const NUMBERS: Readonly<Record<string, Goal>> = {
  head: { yaw: 0, pitch: 0, roll: 0 },
  gaze: { yaw: 0, pitch: 0 },
  place: { x: 0, depth: 0, size: 1, turn: 0 },
  presence: { presence: 1 },
  motion: { liveliness: 1, blinks: 1, gaze: 1, breath: 1 },
  black: { black: 1 },
  ...Object.fromEntries(
    LAYERS.map((layer) => [`layer:${layer}`, Object.fromEntries(LAYER_PARTS.map((part) => [part, 1]))]),
  ),
};

/** The name of a part without whose it is. */
export const kindOf = (part: string): string => part.slice(part.lastIndexOf("/") + 1);

/** The word for a goal without names, where a part can have one. */
function nothingOf(part: string): string | undefined {
  const kind = kindOf(part);
  if (kind === "clip") return STOP;
  return (PLAY_REGIONS as readonly string[]).includes(kind) ? WITH_FACE : undefined;
}

/** A goal to begin with, as text; "" where a name has to be given. */
export function firstGoal(part: string): string {
  const numbers = NUMBERS[kindOf(part)];
  return numbers === undefined ? "" : goalText(part, numbers);
}

/** A goal as text: a name, a number, or all weights or numbers by name; of a clip how it plays, in words. */
export function goalText(part: string, goal: Goal): string {
  const entries = Object.entries(goal);
  const [first] = entries;
  if (first === undefined) return nothingOf(part) ?? WITH_FACE;
  const clip = kindOf(part) === "clip" && entries.length > 1 ? clipCallOf(goal) : null;
  if (clip !== null) return clipWords(clip);
  const numbers = kindOf(part) in NUMBERS;
  if (numbers && takesOneNumber(part) && entries.every(([, value]) => value === first[1])) return String(first[1]);
  const plain = first[1] === 1 && !numbers && !/[=,{}"]/.test(first[0]) && first[0].trim() === first[0];
  if (entries.length === 1 && plain && first[0] !== nothingOf(part)) return first[0];
  return entries.map(([name, value]) => `${keyText(name)} = ${value}`).join(", ");
}

const keyText = (name: string): string => (/^[\w-]+$/.test(name) ? name : JSON.stringify(name));

const NUMBER = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i;
const ENTRY = /^\s*(?:"((?:[^"\\]|\\.)*)"|([^=,"]+?))\s*=\s*([^,]*?)\s*(?:,|$)/;

/** The goal that a text says; an Error with a sentence where it says none. Brackets and quotes may be left out. */
export function parseGoal(part: string, text: string): Record<string, number> {
  const bare = text
    .trim()
    .replace(/^\{(.*)\}$/s, "$1")
    .trim();
  if (bare === "") throw new Error(`Give where ${part} goes: ${exampleOf(part)}.`);
  if (bare.replace(/"(?:[^"\\]|\\.)*"/g, "").includes("=")) return parseEntries(part, bare);
  const numbers = NUMBERS[kindOf(part)];
  const name = unquoted(bare);
  if (numbers === undefined) return name === nothingOf(part) ? {} : { [name]: 1 };
  if (!takesOneNumber(part) || !NUMBER.test(bare)) throw new Error(`${part} goes to numbers: ${exampleOf(part)}.`);
  return Object.fromEntries(Object.keys(numbers).map((each) => [each, Number(bare)]));
}

/** Whether one number says all of a part: it has no other, or all are of one kind, as of a layer. */
const takesOneNumber = (part: string): boolean =>
  Object.keys(NUMBERS[kindOf(part)] ?? {}).length === 1 || kindOf(part).startsWith("layer:");

function parseEntries(part: string, text: string): Record<string, number> {
  const goal: Record<string, number> = {};
  for (let rest = text; rest.trim() !== ""; ) {
    const found = ENTRY.exec(rest);
    if (found === null) throw new Error(`"${rest.trim()}" is no goal: ${exampleOf(part)}.`);
    const [whole, quoted, plain = "", value = ""] = found;
    const name = quoted === undefined ? plain.trim() : unquoted(`"${quoted}"`);
    if (!NUMBER.test(value)) throw new Error(`"${value}" is no number for ${name}; write it with a point: 0.5.`);
    goal[name] = Number(value);
    rest = rest.slice(whole.length);
  }
  return goal;
}

function unquoted(text: string): string {
  if (!/^".*"$/s.test(text)) return text;
  try {
    return String(JSON.parse(text));
  } catch {
    return text.slice(1, -1);
  }
}

const exampleOf = (part: string): string =>
  (kindOf(part) === "look" && "character two, stage, x = 0, y = 0, z = 2") ||
  firstGoal(part) ||
  "a name, or weights such as joy = 0.7, neutral = 0.3";
