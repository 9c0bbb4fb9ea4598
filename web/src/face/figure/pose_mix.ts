/** The weighted sum of poses, as `perform.figures.pose_mix` has it. */

import { BREATH_IN, CHEST, WEIGHT } from "../../link/constants";
import type { FigurePose } from "../../link/figures";
import type { FigureMix, Idle } from "../pose/pose";
import { regionOf, type Skeleton } from "./skeleton";

type Weights = Readonly<Record<string, number>>;

/** A sum of poses; its arrays as of `FigurePose`. */
export interface MixedPose {
  readonly turns: Float64Array;
  readonly travel: Float64Array;
  readonly feet: Float64Array;
  readonly feetTurns: Float64Array;
}

/** A sum of no pose yet. */
export const blankPose = ({ names }: Skeleton): MixedPose => ({
  turns: new Float64Array(3 * names.length),
  travel: new Float64Array(3),
  feet: new Float64Array(6),
  feetTurns: new Float64Array(6),
});

/**
 * Writes the sum of poses by their weights; regions that show another mix have theirs. Rotation vectors are summed: a sum
 * of two poses never leaves the box of a joint's angles in which both lie. Poses that there are not count as the stand.
 */
export function mixFigurePoses(
  poses: ReadonlyMap<string, FigurePose>,
  { poses: whole, regions }: FigureMix,
  idle: Idle,
  { names }: Skeleton,
  into: MixedPose,
): void {
  const own = idleWeights(idle);
  into.turns.fill(0);
  names.forEach((bone, place) => {
    addScaled(poses, regions[regionOf(bone)] ?? whole, "turns", into.turns, 3 * place, 3);
  });
  for (const what of ["travel", "feet", "feetTurns"] as const) {
    into[what].fill(0);
    addScaled(poses, regions.stance ?? whole, what, into[what], 0, into[what].length);
  }
  for (const what of ["turns", "travel", "feet", "feetTurns"] as const)
    addScaled(poses, own, what, into[what], 0, into[what].length);
}

/** The weights of the poses that a figure does by itself: it breathes, shifts its weight, its chest follows its head. */
const idleWeights = ([breath, left, chest]: Idle): Weights => ({
  [BREATH_IN]: breath,
  [WEIGHT[0]]: Math.max(left, 0),
  [WEIGHT[1]]: Math.max(-left, 0),
  [CHEST]: chest,
});

function addScaled(
  poses: ReadonlyMap<string, FigurePose>,
  weights: Weights,
  what: keyof FigurePose,
  into: Float64Array,
  first: number,
  count: number,
): void {
  for (const name in weights) {
    const values = poses.get(name)?.[what];
    if (values === undefined) continue;
    const weight = weights[name] as number;
    for (let at = first; at < first + count; at++) into[at] = (into[at] as number) + weight * (values[at] as number);
  }
}
