/** Blood, tears and sweat of a pose: as the show has them, or where it says nothing what the expressions bring. */

import { COMPLEXION, COMPLEXION_RANGES } from "../../link/constants";
import type { ExpressionDocument } from "../../link/messages";
import { expressionWeights } from "./mix_terms";
import type { Pose } from "./pose";

type Part = keyof typeof COMPLEXION;

const PARTS = Object.keys(COMPLEXION) as Part[];

/** Blood by part of the face, 1 a strong flush and below 0 pallor; tears and sweat, 0..1; and the metres that these have run. */
export type Complexion = Record<Part | "drops", number>;

/** The complexion of a pose; one that a picture or an editor made has what its expressions bring, at once. */
export function complexionOf(pose: Pose, expressions: ReadonlyMap<string, ExpressionDocument>): Complexion {
  const { complexion } = pose;
  if (complexion !== undefined) return named(complexion);
  const whole = broughtBy(expressionWeights(pose), expressions);
  const brought = PARTS.map((part, at) => {
    const region = COMPLEXION[part];
    const isOwn = region !== null && region in pose.regions; // else all of the face brings it: its weights are summed once
    const sum = isOwn ? broughtBy(expressionWeights(pose, region), expressions)[at] : whole[at];
    const [low, high] = COMPLEXION_RANGES[part];
    return Math.min(high, Math.max(low, sum as number));
  });
  return named(brought);
}

/** The sum of what expressions bring by their weights, by part. */
function broughtBy(
  weights: Readonly<Record<string, number>>,
  expressions: ReadonlyMap<string, ExpressionDocument>,
): number[] {
  const sums = PARTS.map(() => 0);
  for (const name in weights)
    expressions.get(name)?.complexion.forEach((number, at) => {
      sums[at] = (sums[at] as number) + (weights[name] as number) * number;
    });
  return sums;
}

/** A complexion from its numbers; what is missing is as at rest. */
export const named = (numbers: readonly number[]): Complexion =>
  Object.fromEntries([...PARTS, "drops"].map((part, at) => [part, numbers[at] ?? 0])) as Complexion;
