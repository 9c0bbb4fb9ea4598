/** A small face for tests: a bent patch of skin with a net of five points. */

import { type Fans, fans } from "../../../face/anatomy/topology";
import type { Net } from "../../session/control_net";
import type { Triple } from "../math/vectors";

const SIDE = 9;

/** A patch of 9 x 9 rows, 8 cm wide, on a cylinder of 10 cm: rows from below, each from the right to the left. */
export interface Patch {
  positions: Float32Array;
  triangles: Uint32Array;
  fans: Fans;
  net: Net;
  tangents: Float32Array;
}

const RADIUS = 0.1;

export function patch(): Patch {
  const count = SIDE * SIDE;
  const positions = new Float32Array(3 * count);
  const tangents = new Float32Array(9 * count);
  for (let row = 0; row < count; row++) {
    const theta = ((row % SIDE) - 4) * 0.1;
    const h = (Math.floor(row / SIDE) - 4) * 0.01;
    const [x, z] = [RADIUS * Math.sin(theta), RADIUS * Math.cos(theta)];
    positions.set([x, h, z], 3 * row);
    const answers: Triple[] = [
      [z, 0, -x],
      [0, 1, 0],
      [x, 0, z],
    ];
    for (const [part, answer] of answers.entries()) tangents.set(answer, 3 * (part * count + row));
  }
  const triangles: number[] = [];
  for (let line = 0; line + 1 < SIDE; line++)
    for (let place = 0; place + 1 < SIDE; place++) {
      const a = line * SIDE + place;
      triangles.push(a, a + 1, a + SIDE, a + SIDE, a + 1, a + SIDE + 1);
    }
  const corners = Uint32Array.from(triangles);
  return { positions, triangles: corners, fans: fans([corners], count), net: netOf(count), tangents };
}

/** Points in the middle (0), left (1) and right (2) of it, above (3) and below (4); each moves its own row and half of
 * the row to its left. */
function netOf(count: number): Net {
  const rows = [40, 42, 38, 58, 22];
  const [corners, weights] = [new Uint16Array(3 * count), new Float32Array(3 * count)];
  rows.forEach((row, place) => {
    corners[3 * row] = place;
    weights[3 * row] = 1;
    corners[3 * (row + 1)] = place;
    weights[3 * (row + 1)] = 0.5;
  });
  return { rows, triangles: new Uint16Array(), corners, weights, mirror: [0, 2, 1, 3, 4] };
}

/** Vectors of the patch's net at rest. */
export const still = (): Float64Array => Float64Array.from({ length: 15 }, (_, at) => (at % 3 === 2 ? 1 : 0));
