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
  const brought = PARTS.map((part, at) => {
    const weights = Object.entries(expressionWeights(pose, COMPLEXION[part] ?? undefined));
    const sum = weights.reduce((total, [name, weight]) => {
      return total + weight * (expressions.get(name)?.complexion[at] ?? 0);
    }, 0);
    const [low, high] = COMPLEXION_RANGES[part];
    return Math.min(high, Math.max(low, sum));
  });
  return named(brought);
}

/** A complexion from its numbers; what is missing is as at rest. */
export const named = (numbers: readonly number[]): Complexion =>
  Object.fromEntries([...PARTS, "drops"].map((part, at) => [part, numbers[at] ?? 0])) as Complexion;
