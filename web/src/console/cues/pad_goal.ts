/** How a cue moves the point of a pad, as `perform/scene/pad_goals.py` has it: its name behind a word, and its place. */

import type { PadState } from "../../link/messages";
import { PAD_PARTS, type PadPart } from "../pads/pad_layout";

export type PadPoint = Readonly<{ pad: string; place: readonly number[] }>;

/** What the name of a pad stands behind. */
const PAD = ":pad ";
const AXES = ["x", "y", "z"] as const;

/** Whether a pad can play a part, by its name at a character. */
export const isPadPart = (kind: string): kind is PadPart => (PAD_PARTS as readonly string[]).includes(kind);

/** The point that a goal moves; null where it is none of a pad. */
export function padPointOf(goal: Readonly<Record<string, number>>): PadPoint | null {
  const name = Object.keys(goal).find((each) => each.startsWith(PAD));
  if (name === undefined) return null;
  return { pad: name.slice(PAD.length), place: AXES.flatMap((axis) => goal[`:${axis}`] ?? []) };
}

/** The goal that moves a point to its place. */
export function goalOfPoint({ pad, place }: PadPoint): Record<string, number> {
  return { [`${PAD}${pad}`]: 1, ...Object.fromEntries(place.map((at, axis) => [`:${AXES[axis]}`, at])) };
}

/** A point as people read it: `pad moods at x 0.2, y -0.5`. */
export const padPointWords = ({ pad, place }: PadPoint): string =>
  `pad ${pad} at ${place.map((at, axis) => `${AXES[axis]} ${at}`).join(", ")}`;

/** The same as the text files write it, without brackets: `pad = "moods", x = 0.2, y = -0.5`. */
export const padPointText = ({ pad, place }: PadPoint): string =>
  [`pad = ${JSON.stringify(pad)}`, ...place.map((at, axis) => `${AXES[axis]} = ${at}`)].join(", ");

/** The points that a part can go to, as the text files write them: each pad that plays it, at each of its looks. */
export const pointsOffered = (kind: string, pads: readonly PadState[]): readonly string[] =>
  pads
    .filter(({ part }) => part === kind)
    .flatMap(({ name, looks }) => looks.map(({ place }) => padPointText({ pad: name, place })));

/** The point of a pad at what a text says of its axes by name; an Error with a sentence where no pad has such a place. */
export function pointAt(pad: string, axes: Readonly<Record<string, number>>): PadPoint {
  const place = AXES.slice(0, Object.keys(axes).length).map((axis) => axes[axis]);
  if (pad === "" || place.length === 0 || place.length < Object.keys(axes).length || place.includes(undefined))
    throw new Error(`A pad goes to a place: ${padPointText({ pad: pad || "moods", place: [0.2, -0.5] })}.`);
  const off = place.findIndex((at) => Math.abs(at as number) > 1);
  if (off >= 0) throw new Error(`${AXES[off]} of a pad goes from -1 to 1, not to ${place[off]}.`);
  return { pad, place: place as number[] };
}
