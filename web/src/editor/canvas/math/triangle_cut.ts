/** The triangles of a head that a part of its picture needs: a drag draws these, not the whole head, again and again. */

import type { Box } from "./boxes";

/** What of a head is drawn: triangles as places in the drawn vertices, and the `width` rows of positions around each vertex. */
export interface Surface {
  readonly rows: ArrayLike<number>;
  readonly width: number;
  readonly triangles: ArrayLike<number>;
}

/**
 * Writes into a list the triangles that may show in a box, and returns how many numbers these are. places: where the rows
 * are on the canvas, (rows, 2) CSS pixels; slack: how far from there they may be.
 */
export function cut(
  { rows, width, triangles }: Surface,
  places: Float32Array,
  box: Box,
  slack: number,
  into: Uint32Array,
): number {
  let count = 0;
  for (let at = 0; at < triangles.length; at += 3) {
    let [left, right, top, bottom] = [Infinity, -Infinity, Infinity, -Infinity];
    for (let corner = at; corner < at + 3; corner++)
      for (let n = 0; n < width; n++) {
        const row = rows[width * (triangles[corner] as number) + n] as number;
        const [x, y] = [places[2 * row] as number, places[2 * row + 1] as number];
        [left, right, top, bottom] = [Math.min(left, x), Math.max(right, x), Math.min(top, y), Math.max(bottom, y)];
      }
    if (right < box.left - slack || left > box.left + box.width + slack) continue;
    if (bottom < box.top - slack || top > box.top + box.height + slack) continue;
    for (let corner = at; corner < at + 3; corner++) into[count++] = triangles[corner] as number;
  }
  return count;
}
