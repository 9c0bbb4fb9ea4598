/** The triangles of a head that a part of its picture needs: a drag draws these, not the whole head, again and again. */

import type { Box } from "./boxes";
import type { Camera } from "./camera";

/** What of a head is drawn: triangles as places in the drawn vertices, and the row of positions of each vertex. */
export interface Surface {
  rows: Uint16Array;
  triangles: Uint16Array;
}

/** The triangles that may show in a box when no row is further than `reach` (metres) from positions (n, 3). */
export function cut(
  { rows, triangles }: Surface,
  camera: Camera,
  positions: Float32Array,
  box: Box,
  reach: number,
): Uint16Array {
  const places = camera.projectAll(positions);
  const slack = reach / camera.metresPerPixel(camera.middle);
  const [left, top] = [box.left - slack, box.top - slack];
  const [right, bottom] = [box.left + box.width + slack, box.top + box.height + slack];
  const kept = new Uint16Array(triangles.length);
  let count = 0;
  for (let at = 0; at < triangles.length; at += 3) {
    const [a, b, c] = [0, 1, 2].map((n) => 2 * (rows[triangles[at + n] as number] as number)) as [
      number,
      number,
      number,
    ];
    if (apart(places, a, b, c, left, right) || apart(places, a + 1, b + 1, c + 1, top, bottom)) continue;
    kept.set(triangles.subarray(at, at + 3), count);
    count += 3;
  }
  return kept.slice(0, count);
}

/** Whether three numbers lie on one side of an interval. */
function apart(places: Float32Array, a: number, b: number, c: number, low: number, high: number): boolean {
  const [x, y, z] = [places[a] as number, places[b] as number, places[c] as number];
  return (x < low && y < low && z < low) || (x > high && y > high && z > high);
}
