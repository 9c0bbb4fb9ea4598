/** The masks of the regions in which an expression can be called alone, from the manifest. */

import { aligned } from "../../link/arrays";
import { PLAY_REGIONS } from "../../link/constants";
import type { RegionDocument } from "../../link/messages";

/** How much belongs to each region, four numbers 0..1 that sum to one: of each row, and of each number of an allowance. */
export interface RegionMasks {
  rows: Float32Array;
  allowances: Float32Array;
}

const ONE = 65535;

/** The masks of a document; an Error where they do not fit `vertices` positions. */
export function readRegionMasks(document: RegionDocument, vertices: number): RegionMasks {
  const shares = (bytes: Uint8Array) => Float32Array.from(new Uint16Array(aligned(bytes)), (count) => count / ONE);
  const masks = { rows: shares(document.rows), allowances: shares(document.allowances) };
  if (masks.rows.length !== PLAY_REGIONS.length * vertices)
    throw new Error(`The regions' masks hold ${masks.rows.length / PLAY_REGIONS.length} rows, the cast ${vertices}.`);
  return masks;
}
