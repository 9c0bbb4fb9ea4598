/**
 * Goals of cues as people write them: as in the text files of docs/howto/cues.md, without their outer brackets, and
 * angles in degrees, as the console has them.
 */

import { ALL, LAYER_PARTS, LAYERS, PLAY_REGIONS, SKIN_FADERS, SPRINGS } from "../../link/constants";
import { clipCallOf, clipWords } from "./clip_goal";
import { goalOfPoint, isPadPart, padPointOf, padPointText, padPointWords, pointAt } from "./pad_goal";

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
  "springs",
  "skin",
  "look",
  ...LAYERS.map((layer) => `layer:${layer}`),
  "clip",
];
export const SCENE_PARTS = ["light", "framing", "black"] as const;

/** The parts of a cue as people look for them: those of each character together, in their order, then of the scene. */
export function partsInOrder(parts: readonly string[], characters: readonly string[]): string[] {
  const ranks = [...CHARACTER_PARTS, ...SCENE_PARTS];
  const owners = [...new Set([...characters, ...parts.map(ownerOf).filter((owner) => owner !== ALL)]), ALL];
  const rank = (part: string): number => owners.indexOf(ownerOf(part)) * ranks.length + ranks.indexOf(kindOf(part));
  return parts.toSorted((one, other) => rank(one) - rank(other));
}

const ownerOf = (part: string): string => part.slice(0, part.lastIndexOf("/"));

/** How the text says that a region goes with the whole face. */
const WITH_FACE = "face";
/** How it says that clips stop. */
export const STOP = "stop";

/** What a goal of each part that is numbers looks like. */
const NUMBERS: Readonly<Record<string, Goal>> = {
  head: { yaw: 0, pitch: 0, roll: 0 },
  gaze: { yaw: 0, pitch: 0 },
  place: { x: 0, depth: 0, size: 1, turn: 0 },
  presence: { presence: 1 },
  motion: { liveliness: 1, blinks: 1, gaze: 1, breath: 1 },
  springs: Object.fromEntries(SPRINGS.map((spring) => [spring, 1])),
  skin: Object.fromEntries(SKIN_FADERS.map((fader) => [fader, 1])),
  black: { black: 1 },
  ...Object.fromEntries(
    LAYERS.map((layer) => [`layer:${layer}`, Object.fromEntries(LAYER_PARTS.map((part) => [part, 1]))]),
  ),
};

/** How far each angle goes either way, in degrees: the show has them in radians. */
const ANGLES: Readonly<Record<string, Readonly<Record<string, number>>>> = {
  head: { yaw: 90, pitch: 90, roll: 90 },
  gaze: { yaw: 40, pitch: 30 },
  place: { turn: 180 },
  look: { yaw: 180, pitch: 90 },
};
const RADIANS = Math.PI / 180;

const furthest = (part: string, name: string): number | undefined => ANGLES[kindOf(part)]?.[name];

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
  const point = padPointOf(goal);
  if (point !== null) return padPointText(point);
  const clip = kindOf(part) === "clip" && entries.length > 1 ? clipCallOf(goal) : null;
  if (clip !== null) return clipWords(clip);
  const numbers = kindOf(part) in NUMBERS;
  if (numbers && takesOneNumber(part) && entries.every(([, value]) => value === first[1])) return String(first[1]);
  const number = (name: string, value: number): string => numberText(part, name, value);
  const plain = first[1] === 1 && !numbers && !/[=,{}"]/.test(first[0]) && first[0].trim() === first[0];
  if (entries.length === 1 && plain && first[0] !== nothingOf(part)) return first[0];
  return entries.map(([name, value]) => `${keyText(name)} = ${number(name, value)}`).join(", ");
}

/** A goal as people read it who do not write it: the point of a pad in words. */
export function goalWords(part: string, goal: Goal): string {
  const point = padPointOf(goal);
  return point === null ? goalText(part, goal) : padPointWords(point);
}

/** A number as people read it: angles in tenths of a degree, places in millimetres. */
function numberText(part: string, name: string, value: number): string {
  const rounded = (number: number, decimals: number): string => String(Number(number.toFixed(decimals)) || 0);
  if (furthest(part, name) !== undefined) return `${rounded(value / RADIANS, 1)}°`;
  return kindOf(part) === "place" ? rounded(value, 3) : String(value);
}

const keyText = (name: string): string => (/^[\w-]+$/.test(name) ? name : JSON.stringify(name));

const NUMBER = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i;
/** The name of a pad: in quotes, or what is no weight of an expression that is called pad. */
const PAD_ENTRY = /^"?pad"?\s*=\s*("(?:[^"\\]|\\.)*"|(?![-+.\d])[^,"\s][^,]*?)\s*(?:,|$)/;
const ENTRY = /^\s*(?:"((?:[^"\\]|\\.)*)"|([^=,"]+?))\s*=\s*([^,]*?)\s*(?:,|$)/;

/**
 * The goal that a text says; an Error with a sentence where it says none. Brackets and quotes may be left out. `before`:
 * the goal that it takes the place of: of numbers those that are not named, or that read as before, stay as they are.
 */
export function parseGoal(part: string, text: string, before?: Goal): Record<string, number> {
  const bare = text
    .trim()
    .replace(/^\{(.*)\}$/s, "$1")
    .trim();
  if (bare === "") throw new Error(`Give where ${part} goes: ${exampleOf(part)}.`);
  const pad = isPadPart(kindOf(part)) ? PAD_ENTRY.exec(bare) : null;
  if (pad !== null) return parsePoint(part, pad, bare);
  if (bare.replace(/"(?:[^"\\]|\\.)*"/g, "").includes("=")) return completed(part, parseEntries(part, bare), before);
  const numbers = NUMBERS[kindOf(part)];
  const name = unquoted(bare);
  if (numbers === undefined) return name === nothingOf(part) ? {} : { [name]: 1 };
  if (!takesOneNumber(part) || !NUMBER.test(bare)) throw new Error(`${part} goes to numbers: ${exampleOf(part)}.`);
  return Object.fromEntries(Object.keys(numbers).map((each) => [each, Number(bare)]));
}

/** The goal that a text says which begins with the name of a pad. */
function parsePoint(part: string, [whole, name = ""]: RegExpExecArray, text: string): Record<string, number> {
  return goalOfPoint(pointAt(unquoted(name), parseEntries(part, text.slice(whole.length))));
}

function completed(part: string, goal: Goal, before?: Goal): Record<string, number> {
  const numbers = NUMBERS[kindOf(part)];
  const reads = (name: string, value: number): string => numberText(part, name, value);
  const kept = Object.entries(before ?? {}).filter(
    ([name, value]) => name in goal && reads(name, value) === reads(name, goal[name] ?? Number.NaN),
  );
  const typed = { ...goal, ...Object.fromEntries(kept) };
  return numbers === undefined ? typed : { ...numbers, ...before, ...typed };
}

/** Whether one number says all of a part: it has no other, or all are of one kind, as of a layer or of springs. */
const takesOneNumber = (part: string): boolean =>
  Object.keys(NUMBERS[kindOf(part)] ?? {}).length === 1 ||
  kindOf(part).startsWith("layer:") ||
  kindOf(part) === "springs";

function parseEntries(part: string, text: string): Record<string, number> {
  const goal: Record<string, number> = {};
  for (let rest = text; rest.trim() !== ""; ) {
    const found = ENTRY.exec(rest);
    if (found === null) throw new Error(`"${rest.trim()}" is no goal: ${exampleOf(part)}.`);
    const [whole, quoted, plain = "", value = ""] = found;
    const name = quoted === undefined ? plain.trim() : unquoted(`"${quoted}"`);
    goal[name] = numberIn(part, name, value);
    rest = rest.slice(whole.length);
  }
  return goal;
}

function numberIn(part: string, name: string, text: string): number {
  const most = furthest(part, name);
  const bare = most === undefined ? text : text.replace(/\s*°$/, "");
  if (!NUMBER.test(bare)) throw new Error(`"${text}" is no number for ${name}; write it with a point: 0.5.`);
  const value = Number(bare);
  if (most === undefined) return value;
  if (Math.abs(value) > most) throw new Error(`${name} goes from -${most}° to ${most}°, not to ${value}°.`);
  return value * RADIANS;
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
  (kindOf(part) === "look" && "character two, stage, yaw = 20°, pitch = 0°, or x = 0, y = 0, z = 2") ||
  firstGoal(part) ||
  `a name, or weights such as joy = 0.7, neutral = 0.3${isPadPart(kindOf(part)) ? ', or pad = "moods", x = 0.2, y = -0.5' : ""}`;
