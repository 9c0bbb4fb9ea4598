/** Keys of the canvas. */

/** Metres of a nudge, and of a fine one (Shift). */
export const NUDGE = 0.0005;
export const FINE_NUDGE = 0.0001;

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

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
