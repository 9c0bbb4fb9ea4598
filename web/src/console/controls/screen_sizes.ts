/** The sizes of screen that the console is laid out for; the styles of all its parts divide at the same places. */

import { unsafeCSS } from "lit";

/** A phone held upright, or a window as narrow: palettes, faders or pads stand below. */
export const NARROW = "(max-width: 599px)";
/** A phone on its side, or a window as low: palettes, faders or pads stand beside the picture. */
export const LOW =
  "((min-width: 600px) and (max-height: 539px)) or ((min-width: 600px) and (max-width: 899px) and (max-height: 859px))";
/** A phone or a small tablet held upright: the bar has no room for words. */
export const UPRIGHT = `${NARROW} or ((max-width: 699px) and (min-height: 860px))`;
/** Too low for lists of what is on air: the T-bars name both ends. */
export const SHORT = `${NARROW} or (max-height: 720px) or ${LOW}`;

/** Too narrow or too low for the mixer's strips and a group of settings beside each other. */
export const TIGHT = "(max-width: 999px) or (max-height: 539px)";

/** The same for a style's `@media`. */
export const [narrow, low, short] = [unsafeCSS(NARROW), unsafeCSS(LOW), unsafeCSS(SHORT)];
export const [tight, upright] = [unsafeCSS(TIGHT), unsafeCSS(UPRIGHT)];
