/** The painted scalp under hair that comes or goes. */

import { Color, MathUtils } from "three";
import type { Look } from "../../link/messages";

/** What a face on air does to the scalp: its weight, and how dark its own scalp is painted, 0..1. */
export interface ScalpShare {
  readonly weight: number;
  readonly scalp: number;
}

/** How much of the scalp is stubble, 0..1, under the weight of the faces that have it: all, when the first hair is wide enough to be seen. */
export const stubbleAt = (weight: number): number => MathUtils.smoothstep(weight, 0, 0.2);

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

/** What a look says of the colour of hair on a mix. */
export type HairLook = Pick<Look, "hair" | "hair_style" | "skin" | "brow" | "fur" | "lacquer">;

const bareColours = new WeakMap<HairLook, Color>();

/** The colour that hair has where it goes, in linear light: of the fur, or of the paint on a mask; else what the face's own would have. */
function bareColour(look: HairLook): Color {
  const colour =
    bareColours.get(look) ??
    new Color()
      .setStyle(look.hair)
      .lerp(new Color().setStyle(look.skin), look.fur)
      .lerp(new Color().setStyle(look.brow), look.lacquer);
  bareColours.set(look, colour);
  return colour;
}

const hairColours = new WeakMap<HairLook, Color>();

function hairColour(look: HairLook): Color {
  const colour = hairColours.get(look) ?? new Color().setStyle(look.hair);
  hairColours.set(look, colour);
  return colour;
}

/**
 * Writes the colour of the hair on a mix of looks, by their weights: in roots of linear light, for in proportion to it a tenth of white
 * hair turns black hair grey, and mixes are brighter than their ends. To who wears none it passes into the colour under it, so that
 * it is seen less and less before it is gone.
 */
export function mixHairColour(looks: readonly (readonly [HairLook, number])[], into: Color): void {
  const seen = looks.filter(([, weight]) => weight > 0);
  const total = seen.reduce((sum, [, weight]) => sum + weight, 0);
  if (total === 0) return;
  const isHaired = seen.some(([look]) => look.hair_style !== "");
  into.setRGB(0, 0, 0);
  for (const [look, weight] of seen) {
    const { r, g, b } = isHaired && look.hair_style === "" ? bareColour(look) : hairColour(look);
    const share = weight / total;
    into.setRGB(into.r + share * Math.sqrt(r), into.g + share * Math.sqrt(g), into.b + share * Math.sqrt(b));
  }
  into.multiply(into);
}
