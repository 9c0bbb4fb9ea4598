/** Bands of the atlas: the lines that lie together in one rectangle of a pass. */

import { ROW_SHIFT } from "../../stage/pass_shaders";
import { BAND } from "./crowd_shaders";

/** The bands that hold these rows, in rising order. */
export const bandsOf = (rows: Uint32Array): Uint32Array =>
  Uint32Array.from(new Set(Array.from(rows, (row) => Math.floor((row >> ROW_SHIFT) / BAND)))).sort();
