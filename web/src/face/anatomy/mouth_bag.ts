/** The lining of the mouth: what of the skin lies behind the lips' line. */

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

/** The rows of the lips' corners, right and left, and of the middles of their upper and lower edge; zeros where `line` is empty. */
export function lipRows(line: ArrayLike<number>, positions: Float32Array): [number, number, number, number] {
  if (line.length === 0) return [0, 0, 0, 0];
  const { upper, lower } = opening(Array.from(line), positions, 3);
  return [upper[0], upper[2], upper[1], lower[1]] as [number, number, number, number];
}
