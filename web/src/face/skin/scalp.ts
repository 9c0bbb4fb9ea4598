/** The painted scalp under hair that comes or goes. */

import { MathUtils } from "three";

/** What a face on air does to the scalp: its weight, and how dark its own scalp is painted, 0..1. */
export interface ScalpShare {
  readonly weight: number;
  readonly scalp: number;
}

/** How much of the scalp is stubble, 0..1, under the weight of the faces that have it: all, when the first hair is wide enough to be seen. */
export const stubbleAt = (weight: number): number => MathUtils.smoothstep(weight, 0, 0.4);

/**
 * How dark the scalp is painted, 0..1. What one face has painted and another has not is stubble: it comes before the hair,
 * also where a full head of hair grows on a balding one. So each shade is as dark as the weight of all with it says.
 */
export function mixScalp(faces: readonly ScalpShare[]): number {
  const shares = faces.filter(({ weight }) => weight > 0).sort((a, b) => a.scalp - b.scalp);
  let [dark, above, painted] = [0, shares.reduce((sum, { weight }) => sum + weight, 0), 0];
  const whole = above || 1;
  for (const { weight, scalp } of shares) {
    dark += (scalp - painted) * stubbleAt(above / whole);
    painted = scalp;
    above -= weight;
  }
  return dark;
}
