/** Rectangles of the canvas. */

/** A rectangle of the canvas in CSS pixels, from its upper left corner. */
export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** The least box that holds both. */
export function union(a: Box, b: Box): Box {
  const [left, top] = [Math.min(a.left, b.left), Math.min(a.top, b.top)];
  const right = Math.max(a.left + a.width, b.left + b.width);
  return { left, top, width: right - left, height: Math.max(a.top + a.height, b.top + b.height) - top };
}

/** What of a box lies in another; empty: no width, no height. */
export function overlap(box: Box, tile: Box): Box {
  const [left, top] = [Math.max(box.left, tile.left), Math.max(box.top, tile.top)];
  const right = Math.min(box.left + box.width, tile.left + tile.width);
  const bottom = Math.min(box.top + box.height, tile.top + tile.height);
  return { left, top, width: Math.max(0, right - left), height: Math.max(0, bottom - top) };
}

/** How much further than asked for a cut reaches, as a share of the asked box: so that the next ones need no new cut. */
const AHEAD = 0.1;

/** Whether a box lies in another. */
export const contains = (outer: Box, inner: Box): boolean =>
  inner.left >= outer.left &&
  inner.top >= outer.top &&
  inner.left + inner.width <= outer.left + outer.width &&
  inner.top + inner.height <= outer.top + outer.height;

/** A box with room around it for what comes next. */
export const expanded = ({ left, top, width, height }: Box): Box => ({
  left: left - AHEAD * width,
  top: top - AHEAD * height,
  width: (1 + 2 * AHEAD) * width,
  height: (1 + 2 * AHEAD) * height,
});

/** Whether a place of the canvas lies in a box. */
export const inBox = (box: Box, x: number, y: number): boolean =>
  x >= box.left && y >= box.top && x < box.left + box.width && y < box.top + box.height;
