/** Who holds which parts, as pages read it: names of parts, and what is in the way of a hand. */

import { ALL } from "../../link/constants";
import type { Lease, Leases, PadState, SeatState } from "../../link/messages";

export type LeasePart = Lease["part"];
/** The parts of a character, in the order of lists. */
export const CHARACTER_PARTS: readonly LeasePart[] = [
  "face",
  "expression",
  "brows",
  "eyes",
  "mouth",
  "channels",
  "head",
  "gaze",
  "pose",
  "place",
];
/** The parts of the scene, whose character is `*`. */
export const SCENE_PARTS: readonly LeasePart[] = ["light", "framing", "black"];
const REGIONS: readonly LeasePart[] = ["brows", "eyes", "mouth"];
export const NOBODY: Leases = { type: "leases", on: false, held: {}, seats: [], you: 0, wishes: [] };

/** The parts that messages of hands play, as `Hands` names these behind the character. */
const PLAYED: Readonly<Record<string, LeasePart>> = {
  fade_face: "face",
  fade_expression: "expression",
  fade_pose: "pose",
  set_channel: "channels",
  set_head: "head",
  set_gaze: "gaze",
};

/** The part that a control of a character plays, null for none; `pads`: those of the show. */
export function partOf(control: string, pads: readonly PadState[] = []): LeasePart | null {
  const [what = "", name] = control.split(":");
  if (what !== "move_pad") return PLAYED[what] ?? null;
  const part = pads.find((pad) => pad.name === name)?.part ?? null;
  return part === "rest" ? "expression" : part;
}

/** The names of a part in `Leases.held`: of each of these characters, or of the scene. */
export const keysOf = (characters: readonly string[], part: LeasePart): readonly string[] =>
  SCENE_PARTS.includes(part) ? [`${ALL}/${part}`] : characters.map((name) => `${name}/${part}`);

/** Who may play a part: its holder, or that of the expression whose region it is; null while it is free. */
function holderOf({ held }: Leases, key: string): SeatState | null {
  const [character, part] = key.split("/") as [string, LeasePart];
  const whole = REGIONS.includes(part) ? held[`${character}/expression`] : undefined;
  return held[key] ?? whole ?? null;
}

/** What others hold of some parts, in the way of who plays them: a whole expression moves its regions too. */
export function heldByOthers(leases: Leases, keys: readonly string[]): ReadonlyMap<string, SeatState> {
  const holders = new Map<string, SeatState>();
  for (const key of leases.on ? keys.flatMap((part) => [part, ...regionsOf(part)]) : []) {
    const holder = holderOf(leases, key);
    if (holder !== null && holder.number !== leases.you) holders.set(key, holder);
  }
  return holders;
}

function regionsOf(key: string): readonly string[] {
  const [character, part] = key.split("/");
  return part === "expression" ? REGIONS.map((region) => `${character}/${region}`) : [];
}

/** What this console's own seat holds of some parts. */
export const heldHere = (leases: Leases, keys: readonly string[]): readonly string[] =>
  keys.filter((key) => leases.held[key]?.number === leases.you);

/** What this seat would release so that others have some parts: a region goes with the expression that it is of. */
export function holdingsOf(leases: Leases, keys: readonly string[]): readonly string[] {
  const whole = (key: string) => `${key.split("/")[0]}/expression`;
  const holdings = keys.map((key) => (leases.held[key] === undefined && isRegion(key) ? whole(key) : key));
  return heldHere(leases, [...new Set(holdings)]);
}

const isRegion = (key: string): boolean => REGIONS.includes(key.split("/")[1] as LeasePart);

/** A part in words: `the face of Kaori`, `the light`; `label`: what people call a character. */
export function wordsOf(key: string, label: (character: string) => string): string {
  const [character, part] = key.split("/") as [string, string];
  return character === ALL ? `the ${part}` : `the ${part} of ${label(character)}`;
}

/** Who holds what, in one sentence: `Ana holds the face of One, Ben the light`. */
export function explain(held: ReadonlyMap<string, SeatState>, label: (character: string) => string): string {
  const parts = new Map<string, string[]>();
  for (const [key, { name }] of held) parts.set(name, [...(parts.get(name) ?? []), wordsOf(key, label)]);
  const said = [...parts].map(([name, keys], at) => `${name} ${at === 0 ? "holds " : ""}${listed(keys)}`);
  return said.join(", ");
}

/** Words in a row: `a, b and c`. */
export const listed = (words: readonly string[]): string =>
  words.length < 2 ? words.join() : `${words.slice(0, -1).join(", ")} and ${words.at(-1)}`;
