/** The lining of the mouth: what of the skin lies behind the lips' line. */

import { MathUtils } from "three";
import { opening } from "./openings";
import { distances, type Fans, neighbours } from "./topology";

/**
 * How far behind the lips each row lies, metres along the mesh; 0 on the outer skin and on all other parts.
 * `line`: the lips' line in walking order; `outside`: a row of the outer skin; `skin`: rows of the skin, the first ones.
 */
export function bagDepths(
  around: Fans,
  positions: Float32Array,
  line: ArrayLike<number>,
  outside: number,
  skin: number,
): Float32Array {
  const depths = new Float32Array(around.starts.length - 1);
  if (line.length === 0) return depths;
  const outer = new Set([outside, ...Array.from(line)]);
  const front = [outside];
  for (let row = front.pop(); row !== undefined; row = front.pop())
    neighbours(around, row, (other) => {
      if (outer.has(other)) return;
      outer.add(other);
      front.push(other);
    });
  const far = distances(around, positions, Array.from(line));
  for (let row = 0; row < skin; row++) {
    const depth = far[row] as number;
    if (!outer.has(row) && Number.isFinite(depth)) depths[row] = depth;
  }
  return depths;
}

/** From the first to the second depth behind the lips, metres, the bag comes to turn as the throat does that lies around it. */
const THROAT = [0.03, 0.05] as const;

/**
 * How much of the head's turn each row takes: of the bag's deep end as much as the nearest of the outer skin, for the head
 * would turn it out of the throat. `bag`: metres behind the lips, of each row of the skin; `outside`: what rows take by their
 * way from the neck's rim.
 */
export function bagTurns(positions: Float32Array, bag: Float32Array, outside: Float32Array): Float32Array {
  const turns = Float32Array.from(outside);
  bag.forEach((depth, row) => {
    const share = MathUtils.smoothstep(depth, ...THROAT);
    if (share > 0)
      turns[row] = MathUtils.lerp(
        outside[row] as number,
        outside[nearestOutside(positions, bag, row)] as number,
        share,
      );
  });
  return turns;
}

function nearestOutside(positions: Float32Array, bag: Float32Array, row: number): number {
  let [nearest, least] = [row, Number.POSITIVE_INFINITY];
  bag.forEach((depth, other) => {
    if (depth > 0) return;
    let square = 0;
    for (let axis = 0; axis < 3; axis++)
      square += ((positions[3 * other + axis] as number) - (positions[3 * row + axis] as number)) ** 2;
    if (square < least) [nearest, least] = [other, square];
  });
  return nearest;
}

/** The rows of the lips' corners, right and left, and of the middles of their upper and lower edge; zeros where `line` is empty. */
export function lipRows(line: ArrayLike<number>, positions: Float32Array): [number, number, number, number] {
  if (line.length === 0) return [0, 0, 0, 0];
  const { upper, lower } = opening(Array.from(line), positions, 3);
  return [upper[0], upper[2], upper[1], lower[1]] as [number, number, number, number];
}
