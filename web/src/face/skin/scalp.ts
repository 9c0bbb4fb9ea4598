/** The painted scalp under hair that comes or goes. */

import { MathUtils } from "three";

/** What a face on air does to the scalp: its weight, whether it wears hair, and how dark its own scalp is painted, 0..1. */
export interface ScalpShare {
  readonly weight: number;
  readonly haired: boolean;
  readonly scalp: number;
}

/** How much of the scalp is stubble, 0..1, under the weight of the faces with hair: all, before hair is long enough to cover it. */
export const stubbleAt = (weight: number): number => MathUtils.smoothstep(weight, 0, 0.3);

/** How dark the scalp is painted, 0..1: as those who wear hair have it where there is stubble, else as the bald have it. */
export function mixScalp(faces: readonly ScalpShare[]): number {
  const haired = faces.filter(({ haired, weight }) => haired && weight > 0);
  const bald = faces.filter(({ haired, weight }) => !haired && weight > 0);
  const stubble = bald.length > 0 ? stubbleAt(total(haired)) : 1;
  return stubble * mean(haired) + (1 - stubble) * mean(bald);
}

const total = (faces: readonly ScalpShare[]): number => faces.reduce((sum, { weight }) => sum + weight, 0);

const mean = (faces: readonly ScalpShare[]): number =>
  faces.reduce((sum, { weight, scalp }) => sum + weight * scalp, 0) / (total(faces) || 1);
