/** How an operator has laid out the console, and as a document that this one, or another tablet, opens the same from. */

import { DEFAULT_EASING, EASING_NAMES, MOST_PADS } from "../../link/constants";
import { isRecord, readJson } from "../../ui/browser_storage";
import type { Axis } from "./axis";
import { REGIONS, type Region } from "./channels";
import { LONGEST, type Timing } from "./timing";

/** Which of the expressions a palette shows. */
export const KINDS = ["performed", "own", "arkit", "makehuman", "poses", "clips"] as const;
export type PaletteKind = (typeof KINDS)[number];
/** Which faders are open. */
export type BankTab = Region | "touched" | "macros";
/** What is shown below: the scene, the layers or the pads of looks (`blend_pads`) in the place of faders and the pads of head and gaze; the others take turns where there is no room for all. */
export const VIEWS = ["palettes", "faders", "pads", "blend_pads", "scene", "layers"] as const;
export type ConsoleView = (typeof VIEWS)[number];
/** Which group of the mixer is shown; the strips stand beside the others where there is room. */
export const MIXER_GROUPS = ["strips", "sources", "parts", "motion", "gaze", "speech"] as const;
export type MixerGroup = (typeof MIXER_GROUPS)[number];

/** What the page of one person can show beside its pads, picture and cues: keys of memories, tiles of clips, the pad of the head. */
export const SOLO_PARTS = ["looks", "lines", "head"] as const;
export type SoloPart = (typeof SOLO_PARTS)[number];

export interface Arrangement {
  readonly timing: Readonly<Record<Axis, Timing>>;
  readonly kind: PaletteKind;
  /** The palette of faces shows the crew's own alone. */
  readonly ownFaces: boolean;
  readonly tab: BankTab;
  /** Left and right of a pair move together. */
  readonly linked: boolean;
  /** Pads go back to the centre when the hand lets go. */
  readonly springs: Readonly<Record<"head" | "gaze", boolean>>;
  readonly view: ConsoleView;
  readonly mixer: MixerGroup;
  /** The pads of looks that stand first, by name: the page of one person has the first two. */
  readonly pads: readonly string[];
  /** What the page of one person shows beside them. */
  readonly solo: Readonly<Record<SoloPart, boolean>>;
  /** The picture shows the character that is played, and not the scene. */
  readonly alone: boolean;
}

export const FIRST: Arrangement = {
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
  pads: ["mouth", "moods"],
  solo: { looks: true, lines: true, head: true },
  alone: false,
};

const VERSION = 2;

export const written = (arrangement: Arrangement): string => JSON.stringify({ version: VERSION, ...arrangement });

const OWN = "; the console begins with its own.";

/** The arrangement in a document, or a sentence why there is none. */
export function parsed(document: string): Arrangement | string {
  const stored = readJson(document);
  if (stored === undefined) return `The layout cannot be read${OWN}`;
  if (!isRecord(stored) || (stored.version !== VERSION && stored.version !== 1))
    return `The layout is of another version${OWN}`;
  const { timing } = stored;
  const [face, expression] = isRecord(timing) ? [timingOf(timing, "face"), timingOf(timing, "expression")] : [];
  if (!face || !expression) return `The layout has no times that a call can take${OWN}`;
  const shown = shownIn(stored);
  return shown === null
    ? `The layout names what this console has not${OWN}`
    : { timing: { face, expression }, ...shown };
}

/** What is shown, and how; layouts of before know no own faces, views, scenes, springs, groups and pads, and of calls by hand no seconds. */
function shownIn(stored: Record<string, unknown>): Omit<Arrangement, "timing"> | null {
  const { ownFaces, springs, view, mixer, pads, solo, alone } = FIRST;
  const all: Record<string, unknown> = { ownFaces, springs, view, mixer, pads, solo, alone, ...stored };
  const parts = Object.entries(PARTS);
  if (!parts.every(([name, isPart]) => isPart(all[name]))) return null;
  return Object.fromEntries(parts.map(([name]) => [name, all[name]])) as unknown as Omit<Arrangement, "timing">;
}

const isSwitch = (value: unknown): value is boolean => typeof value === "boolean";

const isOneOf = (choices: readonly string[], value: unknown): boolean => choices.some((choice) => choice === value);

/** What each part of a document must be. */
const PARTS: Readonly<Record<keyof Omit<Arrangement, "timing">, (value: unknown) => boolean>> = {
  kind: (value) => isOneOf(KINDS, value),
  tab: (value) => isOneOf([...REGIONS, "touched", "macros"], value),
  linked: isSwitch,
  ownFaces: isSwitch,
  springs: (value) => isRecord(value) && isSwitch(value.head) && isSwitch(value.gaze),
  view: (value) => isOneOf(VIEWS, value),
  mixer: (value) => isOneOf(MIXER_GROUPS, value),
  pads: (value) => Array.isArray(value) && value.length <= MOST_PADS && value.every((name) => typeof name === "string"),
  solo: (value) => isRecord(value) && SOLO_PARTS.every((part) => isSwitch(value[part])),
  alone: isSwitch,
};

/** The time of an axis in a document, null where a call cannot take it. */
function timingOf(timing: Record<string, unknown>, axis: Axis): Timing | null {
  const stored = timing[axis];
  if (!isRecord(stored)) return null;
  const { seconds: storedSeconds, easing: named, byHand = storedSeconds === null } = stored;
  const seconds = storedSeconds === null ? FIRST.timing[axis].seconds : storedSeconds;
  const easing = EASING_NAMES.find((name) => name === named);
  const isValid = typeof seconds === "number" && seconds >= 0 && seconds <= LONGEST && isSwitch(byHand);
  return isValid && easing !== undefined ? { seconds, easing, byHand } : null;
}
