/** Where blood shows on the generic face. */

import { MathUtils } from "three";
import { BLOOD_SPOTS } from "../../link/constants";

/** What of the blood lies in spots, in the order of their attribute. */
export const SPOTS = Object.keys(BLOOD_SPOTS) as (keyof typeof BLOOD_SPOTS)[];

/** Metres before the eyes' origin where spots come to lie on the face, and how soon. */
const [FRONT, RAMP] = [0.02, 0.05];

/** How much each row of the generic face (metres) belongs to each spot, four numbers a row. */
export function bloodSpots(positions: Float32Array): Float32Array {
  return Float32Array.from({ length: (4 * positions.length) / 3 }, (_, at) => {
    const [x = 0, y = 0, z = 0] = positions.subarray(3 * (at >> 2), 3 * (at >> 2) + 3);
    const ahead = MathUtils.smoothstep(z, FRONT, FRONT + RAMP);
    const spots = BLOOD_SPOTS[SPOTS[at & 3] as (typeof SPOTS)[number]];
    return spots.reduce((sum, [across, up, wide, tall, share]) => {
      return sum + ahead * share * Math.exp(-(((Math.abs(x) - across) / wide) ** 2) - ((y - up) / tall) ** 2);
    }, 0);
  });
}
