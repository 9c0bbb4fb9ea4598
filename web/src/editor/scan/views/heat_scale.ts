/** The colours of distances between face and scan, for shader and legend alike. */

import type { Triple } from "../../canvas/math/vectors";

/** Millimetres and colour (sRGB, 0 to 255); colours between are mixed, beyond the last it stays. */
export const HEAT_STOPS: readonly (readonly [number, Readonly<Triple>])[] = [
  [0, [38, 84, 124]],
  [0.25, [72, 160, 140]],
  [0.5, [198, 212, 110]],
  [1, [244, 162, 58]],
  [2, [214, 40, 40]],
];
/** What the scan does not show. */
export const UNSEEN: Readonly<Triple> = [92, 96, 102];

/** The colour of a distance. */
export function heatOf(millimetres: number): Readonly<Triple> {
  if (Number.isNaN(millimetres)) return UNSEEN;
  const upper = HEAT_STOPS.findIndex(([stop]) => stop >= millimetres);
  if (upper < 0) return (HEAT_STOPS.at(-1) as (typeof HEAT_STOPS)[number])[1];
  const [to, above] = HEAT_STOPS[upper] as (typeof HEAT_STOPS)[number];
  const [from, below] = HEAT_STOPS[Math.max(0, upper - 1)] as (typeof HEAT_STOPS)[number];
  const share = to === from ? 0 : (millimetres - from) / (to - from);
  return [0, 1, 2].map((part) => (below[part] as number) * (1 - share) + (above[part] as number) * share) as Triple;
}

/** The scale from left to right as a background, each stop as far from the next. */
export const heatGradient = (): string =>
  `linear-gradient(to right, ${HEAT_STOPS.map(([, colour]) => `rgb(${colour.join(" ")})`).join(", ")})`;
