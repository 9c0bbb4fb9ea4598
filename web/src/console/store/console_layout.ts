/** How an operator has laid out the console, and as a document that this one, or another tablet, opens the same from. */

import { DEFAULT_EASING, EASING_NAMES } from "../../link/constants";
import type { Axis } from "./axis";
import { REGIONS, type Region } from "./channels";
import { LONGEST, type Timing } from "./timing";

/** Which of the expressions a palette shows. */
export const KINDS = ["performed", "own", "arkit", "makehuman"] as const;
export type PaletteKind = (typeof KINDS)[number];
/** Which faders are open. */
export type BankTab = Region | "touched";
/** What is shown below: the scene, or the layers, in the place of faders and pads; the others take turns where there is no room for all. */
export const VIEWS = ["palettes", "faders", "pads", "scene", "layers"] as const;
export type View = (typeof VIEWS)[number];
/** Which group of the mixer is shown; the strips stand beside the others where there is room. */
export const MIXER_GROUPS = ["strips", "sources", "parts", "motion", "gaze", "speech"] as const;
export type MixerGroup = (typeof MIXER_GROUPS)[number];

export interface ConsoleLayout {
  readonly timing: Readonly<Record<Axis, Timing>>;
  readonly kind: PaletteKind;
  /** The palette of faces shows the crew's own alone. */
  readonly ownFaces: boolean;
  readonly tab: BankTab;
  /** Left and right of a pair move together. */
  readonly linked: boolean;
  /** Pads go back to the centre when the hand lets go. */
  readonly springs: Readonly<Record<"head" | "gaze", boolean>>;
  readonly view: View;
  readonly mixer: MixerGroup;
  /** The picture shows the character that is played, and not the scene. */
  readonly alone: boolean;
}

export const FIRST: ConsoleLayout = {
  timing: {
    face: { seconds: 2, easing: DEFAULT_EASING, byHand: false },
    expression: { seconds: 0.5, easing: DEFAULT_EASING, byHand: false },
  },
  kind: "performed",
  ownFaces: false,
  tab: "brows",
  linked: true,
  springs: { head: true, gaze: true },
  view: "palettes",
  mixer: "strips",
  alone: false,
};

const VERSION = 2;

export const written = (layout: ConsoleLayout): string => JSON.stringify({ version: VERSION, ...layout });

const OWN = "; the console begins with its own.";

/** The arrangement in a document, or a sentence why there is none. */
export function parsed(document: string): ConsoleLayout | string {
  let found: unknown;
  try {
    found = JSON.parse(document);
  } catch {
    return `The layout cannot be read${OWN}`;
  }
  if (!isRecord(found) || (found.version !== VERSION && found.version !== 1))
    return `The layout is of another version${OWN}`;
  const { timing } = found;
  const [face, expression] = isRecord(timing) ? [timingOf(timing, "face"), timingOf(timing, "expression")] : [];
  if (!face || !expression) return `The layout has no times that a call can take${OWN}`;
  const shown = shownIn(found);
  return shown === null
    ? `The layout names what this console has not${OWN}`
    : { timing: { face, expression }, ...shown };
}

/** What is shown, and how; layouts of before know no own faces, views, scenes, springs and groups, and of calls by hand no seconds. */
function shownIn(found: Record<string, unknown>): Omit<ConsoleLayout, "timing"> | null {
  const { kind, tab, linked, ownFaces = false, springs: sprung = FIRST.springs } = found;
  const { view = FIRST.view, mixer = FIRST.mixer, alone = false } = found;
  const springs = springsOf(sprung);
  if (!isOneOf(KINDS, kind) || !isOneOf([...REGIONS, "touched"] as const, tab) || !isOneOf(VIEWS, view)) return null;
  if (!isOneOf(MIXER_GROUPS, mixer)) return null;
  if (!isSwitch(linked) || !isSwitch(ownFaces) || !isSwitch(alone) || springs === null) return null;
  return { kind, tab, linked, ownFaces, springs, view, mixer, alone };
}

const isSwitch = (value: unknown): value is boolean => typeof value === "boolean";

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

const isOneOf = <Choice extends string>(choices: readonly Choice[], value: unknown): value is Choice =>
  choices.some((choice) => choice === value);

function springsOf(found: unknown): ConsoleLayout["springs"] | null {
  if (!isRecord(found)) return null;
  const { head, gaze } = found;
  return isSwitch(head) && isSwitch(gaze) ? { head, gaze } : null;
}

/** The time of an axis in a document, null where a call cannot take it. */
function timingOf(timing: Record<string, unknown>, axis: Axis): Timing | null {
  const found = timing[axis];
  if (!isRecord(found)) return null;
  const { seconds: told, easing: named, byHand = told === null } = found;
  const seconds = told === null ? FIRST.timing[axis].seconds : told;
  const easing = EASING_NAMES.find((name) => name === named);
  const known = typeof seconds === "number" && seconds >= 0 && seconds <= LONGEST && isSwitch(byHand);
  return known && easing !== undefined ? { seconds, easing, byHand } : null;
}
