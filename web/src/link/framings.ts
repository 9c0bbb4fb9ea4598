/** Framings as states name them: whom the picture holds, and how much of them. */

import { FRAMING_SIZED, SHOT_SIZES } from "./constants";

export type ShotSize = (typeof SHOT_SIZES)[number];

/** Heads alone. */
export const PORTRAIT_SIZE: ShotSize = SHOT_SIZES[0];

/** A framing of whom another holds, in a shot of this size. */
export const inSize = (framing: string, size: ShotSize): string =>
  size === PORTRAIT_SIZE ? heldBy(framing) : `${heldBy(framing)}${FRAMING_SIZED}${size}`;

/** Whom a framing holds, as text. */
export const heldBy = (framing: string): string => framing.split(FRAMING_SIZED)[0] as string;

/** The size of the shot of a framing; a portrait where it says none that we know. */
export function sizeOf(framing: string): ShotSize {
  const said = framing.split(FRAMING_SIZED)[1];
  return SHOT_SIZES.find((size) => size === said) ?? PORTRAIT_SIZE;
}

/** Whether any of these framings shows figures. */
export const showsFigures = (framings: readonly string[]): boolean =>
  framings.some((framing) => sizeOf(framing) !== PORTRAIT_SIZE);

/** The sizes that show figures. */
export const FIGURE_SHOTS: readonly ShotSize[] = SHOT_SIZES.filter((size) => size !== PORTRAIT_SIZE);

/** A mix of framings with all of its shots of one character. */
export const framedAlone = (framing: Readonly<Record<string, number>>, name: string): Record<string, number> =>
  Object.fromEntries(weightsBy(framing, (key) => inSize(name, sizeOf(key))));

/** The sum of the weights of a mix of framings by a key of theirs (`heldBy`, `sizeOf`). */
export function weightsBy<Key extends string>(
  framing: Readonly<Record<string, number>>,
  key: (framing: string) => Key,
): Map<Key, number> {
  const sums = new Map<Key, number>();
  for (const [name, weight] of Object.entries(framing)) sums.set(key(name), (sums.get(key(name)) ?? 0) + weight);
  return sums;
}
