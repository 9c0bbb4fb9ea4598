/** What hands hold of a character, by part: it stays above what a clip plays there. */

import { LAYER_PARTS } from "../../link/constants";
import type { CharacterState, ExpressionDocument } from "../../link/messages";
import { type Region, regionOf } from "../store/channels";
import { handsOf } from "../store/held_state";

type Part = (typeof LAYER_PARTS)[number];

/** What a hand holds: a channel, or how head or eyes turn. */
export interface Held {
  readonly name: string;
  readonly parts: readonly Part[];
  /** The weight of a channel; 0 for `head` and `gaze`. */
  readonly weight: number;
}

const LEAST = 0.001;
const PARTS: Readonly<Partial<Record<Region, Part>>> = {
  brows: "brows",
  eyes: "eyes",
  mouth: "mouth",
  jaw: "mouth",
  cheeks: "mouth",
  tongue: "mouth",
  nose: "rest",
  ears: "rest",
};

/** The parts of the face that a channel moves: one, or all of it. */
function partsOf(name: string, expressions: readonly ExpressionDocument[]): readonly Part[] {
  const known = expressions.find((expression) => expression.name === name);
  const part = PARTS[regionOf(known ?? { name, kind: "arkit", region: "" })];
  return part === undefined ? LAYER_PARTS.filter((each) => each !== "head" && each !== "gaze") : [part];
}

/** What hands hold of these parts; `expressions`: of the cast, which say where a channel belongs. */
export function heldOf(
  character: CharacterState,
  parts: readonly Part[],
  expressions: readonly ExpressionDocument[],
): readonly Held[] {
  const { channels, head, gaze } = handsOf(character);
  const turned = (values: readonly number[]): boolean => values.some((value) => Math.abs(value) > LEAST);
  const held: Held[] = Object.entries(channels)
    .filter(([, weight]) => Math.abs(weight) > LEAST)
    .map(([name, weight]) => ({ name, weight, parts: partsOf(name, expressions) }));
  if (turned(head)) held.push({ name: "head", weight: 0, parts: ["head"] });
  if (turned(gaze)) held.push({ name: "gaze", weight: 0, parts: ["gaze"] });
  return held.filter((each) => each.parts.some((part) => parts.includes(part)));
}
