/** What is said of several control points at once. */

import type { Vector } from "../session/control_net";

/** The number that all places share in one part of their vectors, or null. */
export function commonOf(vectors: Float64Array, places: readonly number[], part: number): number | null {
  const values = places.map((place) => vectors[3 * place + part] as number);
  const [first] = values;
  return first !== undefined && values.every((value) => Math.abs(value - first) < 1e-9) ? first : null;
}

/** The vectors with those of `places` copied to their mirror images: turned the other way round, as high, as far off. */
export function mirrored(vectors: readonly Vector[], places: readonly number[], mirror: readonly number[]): Vector[] {
  const copied: Vector[] = vectors.map((vector) => [...vector]);
  for (const place of places) {
    const image = mirror[place] ?? -1;
    const [turn, height, ratio] = vectors[place] as Vector;
    if (image === place)
      copied[place] = [0, height, ratio]; // on the midline nothing turns
    else if (image >= 0) copied[image] = [-turn, height, ratio];
  }
  return copied;
}
