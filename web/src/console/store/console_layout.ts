/** How an operator has laid out the console, and as a document that another tablet opens the same from. */

import { DEFAULT_EASING, EASING_NAMES } from "../../link/constants";
import type { Axis } from "./axis";
import { REGIONS, type Region } from "./channels";
import { LONGEST, type Timing } from "./timing";

/** Which of the expressions a palette shows. */
export const KINDS = ["performed", "own", "arkit", "makehuman"] as const;
export type PaletteKind = (typeof KINDS)[number];
/** Which faders are open. */
export type BankTab = Region | "touched";

export interface ConsoleLayout {
  readonly timing: Readonly<Record<Axis, Timing>>;
  readonly kind: PaletteKind;
  /** The palette of faces shows the crew's own alone. */
  readonly ownFaces: boolean;
  readonly tab: BankTab;
  /** Left and right of a pair move together. */
  readonly linked: boolean;
}

export const FIRST: ConsoleLayout = {
  timing: { face: { seconds: 2, easing: DEFAULT_EASING }, expression: { seconds: 0.5, easing: DEFAULT_EASING } },
  kind: "performed",
  ownFaces: false,
  tab: "brows",
  linked: true,
};

const VERSION = 1;

export const written = (layout: ConsoleLayout): string => JSON.stringify({ version: VERSION, ...layout });

/** The arrangement in a document, or a sentence why there is none. */
export function parsed(document: string): ConsoleLayout | string {
  let found: unknown;
  try {
    found = JSON.parse(document);
  } catch {
    return "The layout kept in the show file cannot be read; the console begins with its own.";
  }
  if (!isRecord(found) || found["version"] !== VERSION)
    return "The layout kept in the show file is of another version; the console begins with its own.";
  const { timing, kind, tab, linked, ownFaces = false } = found; // layouts of before know no palette of own faces
  if (!isRecord(timing) || !isTiming(timing["face"]) || !isTiming(timing["expression"]))
    return "The layout kept in the show file has no times that a call can take; the console begins with its own.";
  if (
    !isOneOf(KINDS, kind) ||
    !isOneOf([...REGIONS, "touched"] as const, tab) ||
    !isSwitch(linked) ||
    !isSwitch(ownFaces)
  )
    return "The layout kept in the show file names what this console has not; it begins with its own.";
  const of = ({ seconds, easing }: Timing): Timing => ({ seconds, easing });
  return { timing: { face: of(timing["face"]), expression: of(timing["expression"]) }, kind, tab, linked, ownFaces };
}

const isSwitch = (value: unknown): value is boolean => typeof value === "boolean";

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

const isOneOf = <Choice extends string>(choices: readonly Choice[], value: unknown): value is Choice =>
  choices.some((choice) => choice === value);

function isTiming(value: unknown): value is Timing {
  if (!isRecord(value)) return false;
  const { seconds, easing } = value;
  const known = EASING_NAMES.some((name) => name === easing);
  return known && (seconds === null || (typeof seconds === "number" && seconds >= 0 && seconds <= LONGEST));
}
