/** Bands of the atlas: the lines that lie together in one rectangle of a pass. */

import { ROW_SHIFT } from "../../../face/gpu/pass_shaders";
import { BAND } from "./atlas_shaders";

/** The bands that hold these rows, in rising order. */
export function bandsOf(rows: Uint32Array): Uint32Array {
  const bands = new Set<number>();
  for (const row of rows) bands.add(Math.floor((row >> ROW_SHIFT) / BAND));
  return Uint32Array.from(bands).sort();
}
