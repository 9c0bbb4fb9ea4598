/** Where looks stand on a pad: near enough to tell apart, and how they are moved, spread and scaled. Nothing here touches the page. */

import { LEAST_APART, MOST_LOOKS } from "../../link/constants";
import type { CharacterState, PadLook, PadState } from "../../link/messages";
import { within } from "../../ui/travel";
import type { LookKind } from "../store/axis";
import type { PadPlace } from "./blend_space";

/** What a pad plays: faces, expressions of the whole face or of one region, or poses of the figure. */
export type PadPart = PadState["part"];
/** A pad that is made or changed. */
export type PadContent = Pick<PadState, "name" | "part" | "dimensions"> & { readonly looks: readonly PadLook[] };
export const PAD_PARTS: readonly PadPart[] = ["expression", "brows", "eyes", "mouth", "rest", "face", "pose"];
export const PART_WORDS: Readonly<Record<PadPart, string>> = {
  face: "faces",
  expression: "expressions",
  brows: "brows",
  eyes: "eyes",
  mouth: "mouth",
  rest: "rest of the face",
  pose: "poses of the figure",
};

/** What the looks of a pad are made of. */
export const kindOf = (part: PadPart): LookKind => (part === "face" || part === "pose" ? part : "expression");
const WAY = { low: -1, high: 1 };
/** A little more than that, for numbers are rounded on their way. */
const APART = LEAST_APART * 1.001;
/** Of half a pad: the ring on which looks are spread, whose pictures then have room. */
const RING = 0.8;
const LONGEST_LABEL = 40;
const LONGEST_NAME = 24;
/** Weights below are no part of what shows. */
const LEAST_SHOWN = 0.005;
/** Names in the mix of a look. */
const MOST_NAMES = 24;

/** How far two places are from each other. */
export const apart = (a: PadPlace, b: PadPlace): number => Math.hypot(...a.map((at, axis) => at - (b[axis] as number)));

/** What a name shows where nothing is played. */
export const restOf = (part: PadPart): string => RESTS[kindOf(part)];

const RESTS: Readonly<Record<LookKind, string>> = { face: "generic", expression: "neutral", pose: "stand" };

/** Where the point goes that is put back: to the look at rest, or where there is none to the middle. */
export function neutralPlace({ part, dimensions, looks }: Omit<PadContent, "name">): number[] {
  const rest = looks.find(({ mix }) => (mix[restOf(part)] ?? 0) > 0.999);
  return rest?.place ?? new Array(dimensions).fill(0);
}

/** The name in a look's mix that weighs most. */
export const heaviest = ({ mix }: Pick<PadLook, "mix">): string =>
  Object.entries(mix).reduce((best, next) => (next[1] > best[1] ? next : best), ["", 0])[0];

/** The nearest place to a wanted one that no look is too near to; `others`: their places. Null where there is none. */
export function freePlace(wanted: PadPlace, others: readonly PadPlace[]): number[] | null {
  let place = wanted.map((at) => within(at, WAY));
  for (let pass = 0; pass < 16; pass += 1) {
    const near = others.find((other) => apart(other, place) < APART);
    if (near === undefined) return place;
    const way = apart(near, place);
    const turn = pass * 2.4; // another direction each time, where two hold each other in a corner
    const away = place.map((at, axis) =>
      way > 1e-6 && pass < 4
        ? (at - (near[axis] as number)) / way
        : ([Math.cos(turn), Math.sin(turn), 0][axis] as number),
    );
    place = away.map((direction, axis) => within((near[axis] as number) + direction * APART * 1.01, WAY));
  }
  return null;
}

/** The looks with one moved to a place, or as near to it as others leave room; as they are where there is none. */
export function withMoved(looks: readonly PadLook[], at: number, to: PadPlace): readonly PadLook[] {
  const others = looks.filter((_, index) => index !== at).map(({ place }) => place);
  const place = freePlace(to, others);
  return place === null ? looks : looks.map((look, index) => (index === at ? { ...look, place } : look));
}

/** The looks with another one at a place, under its label or the next free one; null where there is no room. */
export function withLook(looks: readonly PadLook[], look: PadLook): readonly PadLook[] | null {
  const place = freePlace(
    look.place,
    looks.map((other) => other.place),
  );
  if (place === null || looks.length >= MOST_LOOKS) return null;
  return [...looks, { ...look, place, label: freeLabel(look.label, looks) }];
}

/** A label that no look has: a number behind it where one does. */
export function freeLabel(label: string, looks: readonly Pick<PadLook, "label">[]): string {
  const taken = new Set(looks.map((look) => look.label.toLowerCase()));
  const base = label.trim().slice(0, LONGEST_LABEL - 3) || "Look";
  return [base, ...looks.map((_, at) => `${base} ${at + 2}`)].find((each) => !taken.has(each.toLowerCase())) as string;
}

/** The roomiest place of a pad, for a look that is put there without a pointer. */
export function roomiest(looks: readonly PadLook[], dimensions: number): number[] {
  const steps = Array.from({ length: 9 }, (_, at) => (at - 4) / 5);
  const axes = Array.from({ length: dimensions }, () => steps);
  const all = axes.reduce<number[][]>(
    (places, axis) => places.flatMap((place) => axis.map((at) => [...place, at])),
    [[]],
  );
  const room = (place: PadPlace): number => Math.min(4, ...looks.map((look) => apart(look.place, place)));
  return all.reduce(
    (best, place) => (room(place) > room(best) + 1e-9 ? place : best),
    all[(all.length - 1) / 2] as number[],
  );
}

/** Evenly apart: along a line, or on a ring in the order in which they lie around, a look at rest in the middle. */
export function spread({ part, dimensions, looks }: Omit<PadContent, "name">): readonly PadLook[] {
  if (dimensions === 1) return onLine(looks);
  const middle = looks.findIndex(({ mix }) => (mix[restOf(part)] ?? 0) > 0.999);
  const around = looks
    .map((look, at) => ({ at, turn: Math.atan2(look.place[1] as number, look.place[0] as number) }))
    .filter(({ at }) => at !== middle)
    .sort((a, b) => a.turn - b.turn);
  return looks.map((look, at) => {
    const step = around.findIndex((each) => each.at === at);
    if (step < 0) return { ...look, place: new Array(dimensions).fill(0) };
    const turn = (around[0]?.turn ?? 0) + (2 * Math.PI * step) / around.length;
    return {
      ...look,
      place: [RING * Math.cos(turn), RING * Math.sin(turn), look.place[2] as number].slice(0, dimensions),
    };
  });
}

function onLine(looks: readonly PadLook[]): readonly PadLook[] {
  const order = [...looks].sort((a, b) => (a.place[0] as number) - (b.place[0] as number));
  const step = (2 * RING) / Math.max(1, looks.length - 1);
  return looks.map((look) => ({ ...look, place: [order.indexOf(look) * step - RING] }));
}

/** All nearer to the middle or farther from it, as far as they stay on the pad and apart. */
export function scaled(looks: readonly PadLook[], factor: number): readonly PadLook[] {
  const farthest = Math.max(...looks.flatMap(({ place }) => place.map(Math.abs)));
  const nearest = Math.min(
    ...looks.flatMap((look, at) => looks.slice(0, at).map((other) => apart(look.place, other.place))),
  );
  const by = Math.max(Math.min(factor, farthest === 0 ? 1 : 1 / farthest), Math.min(1, APART / nearest));
  return looks.map((look) => ({ ...look, place: look.place.map((at) => within(at * by, WAY)) }));
}

/** What shows of what a pad plays, as a look's mix; null where nothing does. */
export function shownMix(
  part: PadPart,
  air: Pick<CharacterState, "faces" | "expressions" | "regions" | "figure">,
): Record<string, number> | null {
  const all = mixOf(part, air);
  const shown = Object.entries(all)
    .filter(([, weight]) => weight >= LEAST_SHOWN)
    .sort(([, x], [, y]) => y - x)
    .slice(0, MOST_NAMES);
  const total = shown.reduce((sum, [, weight]) => sum + weight, 0);
  return total === 0 ? null : Object.fromEntries(shown.map(([name, weight]) => [name, weight / total]));
}

function mixOf(
  part: PadPart,
  { faces, expressions, regions, figure }: Pick<CharacterState, "faces" | "expressions" | "regions" | "figure">,
): Record<string, number> {
  if (part === "face") return faces;
  if (part === "pose") return figure?.poses ?? { [restOf(part)]: 1 };
  return part === "expression" ? expressions : (regions[part] ?? expressions);
}

/** A name that a pad can have, as near to what was typed as addresses of OSC allow; "" for nothing of it. */
export const padName = (typed: string): string =>
  typed
    .trim()
    .replace(/[\s/*?[\]{}#,:]+/g, "-")
    .slice(0, LONGEST_NAME);

/** Which pad has a name already, whatever its case, other than the one that is called `own`; "" for none. */
export function nameTaken(name: string, own: string, pads: readonly Pick<PadState, "name">[]): string {
  const same = (other: string): boolean => other !== own && other.toLowerCase() === name.toLowerCase();
  return pads.find((pad) => same(pad.name))?.name ?? "";
}

/** A name that no pad has: a number behind it where one does. */
export function freeName(name: string, pads: readonly Pick<PadState, "name">[]): string {
  const taken = new Set(pads.map((pad) => pad.name.toLowerCase()));
  const base = name.slice(0, LONGEST_NAME - 3);
  return [base, ...pads.map((_, at) => `${base}-${at + 2}`)].find((each) => !taken.has(each.toLowerCase())) as string;
}
