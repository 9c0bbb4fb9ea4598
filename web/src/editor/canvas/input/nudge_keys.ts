/** Keys of the canvas. */

import { ARROWS } from "../../../ui/gestures";
import type { Triple } from "../math/vectors";

/** Metres of a nudge, and of a fine one (Shift). */
export const NUDGE = 0.0005;
export const FINE_NUDGE = 0.0001;

/** Which way a key goes from needle to needle; undefined: it does not. */
export const stepOf = ({ key }: Pick<KeyboardEvent, "key">): -1 | 1 | undefined =>
  key === "," ? -1 : key === "." ? 1 : undefined;

/** The place after (or before) the selected one, from the crown down, around at the end; undefined where there is none. */
export function nextPlace(
  needles: readonly { place: number; head: Triple }[],
  selected: number | undefined,
  by: -1 | 1,
): number | undefined {
  const down = [...needles].sort((a, b) => b.head[1] - a.head[1] || a.head[0] - b.head[0]);
  const at = down.findIndex(({ place }) => place === selected);
  const next = at < 0 ? (by > 0 ? 0 : -1) : (at + by) % Math.max(1, down.length);
  return down.at(next)?.place;
}

/** Metres to the right, up and off the surface that a key means; undefined: none. */
export function nudgeOf({
  key,
  shiftKey,
  altKey,
}: Pick<KeyboardEvent, "key" | "shiftKey" | "altKey">): [number, number, number] | undefined {
  const arrow = ARROWS[key];
  if (arrow === undefined) return undefined;
  const step = shiftKey ? FINE_NUDGE : NUDGE;
  if (!altKey) return [arrow[0] * step, arrow[1] * step, 0];
  return arrow[1] === 0 ? undefined : [0, 0, arrow[1] * step];
}
