/** What part of the time charts show: zoomed and moved, within the whole. Seconds. */

import { sinceOf } from "../../ui/show_times";

export interface View {
  min: number;
  max: number;
}

const SHORTEST = 1;

/** The same within the whole, no shorter than a second. */
export function within({ min, max }: View, whole: View): View {
  const length = Math.min(Math.max(max - min, SHORTEST), whole.max - whole.min);
  const middle = (min + max) / 2;
  const begin = Math.min(Math.max(middle - length / 2, whole.min), whole.max - length);
  return { min: begin, max: begin + length };
}

/** Zoomed by a factor (below 1: nearer) about a time, which stays where it is. */
export const zoomAt = ({ min, max }: View, factor: number, at: number, whole: View): View => {
  const length = Math.min(Math.max((max - min) * factor, SHORTEST), whole.max - whole.min);
  const part = (at - min) / (max - min || 1);
  return within({ min: at - part * length, max: at + (1 - part) * length }, whole);
};

/** Moved by a part of what shows; later where it is above 0. */
export const pan = ({ min, max }: View, part: number, whole: View): View => {
  const by = part * (max - min);
  return within({ min: min + by, max: max + by }, whole);
};

/** After fingers have moved: each held the time under it. `before`, `now`: where they are, 0 to 1 of the width. */
export function pinch(view: View, before: readonly number[], now: readonly number[], whole: View): View {
  const length = view.max - view.min;
  const [one = 0, other] = before;
  const [moved = one, apart] = now;
  if (other === undefined || apart === undefined) return pan(view, one - moved, whole);
  const held = Math.abs(other - one);
  const wide = Math.abs(apart - moved);
  if (held < 0.01 || wide < 0.01) return view;
  const longer = Math.min(Math.max((length * held) / wide, SHORTEST), whole.max - whole.min);
  const at = view.min + ((one + other) / 2) * length;
  const place = (moved + apart) / 2;
  return within({ min: at - place * longer, max: at + (1 - place) * longer }, whole);
}

/** A time at the axis: `04:09`, `−00:12` before the beginning of A, tenths where there are some. */
export function axisTime(seconds: number): string {
  const tenths = Math.round(Math.abs(seconds) * 10);
  const text = sinceOf(Math.floor(tenths / 10)).replace(/^0:/, "");
  return `${seconds < 0 && tenths > 0 ? "−" : ""}${text}${tenths % 10 === 0 ? "" : `.${tenths % 10}`}`;
}
