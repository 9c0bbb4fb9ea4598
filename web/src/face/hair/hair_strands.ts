/** Strands of hair carried by the skin of a face, and their mix. */

import type { HairStrands } from "../../link/strands";

/** One style's strands on one face: metres from each strand's anchor, (strands x stations, 3). */
export type Offsets = Float32Array;

/**
 * The strands on a face, less their anchors: linear in the face's positions (`omote.model.hair.place_strands`), so that a mix
 * of faces wears the mix of their hair.
 */
export function offsetsOn(hair: HairStrands, generic: Float32Array, face: Float32Array): Offsets {
  const { anchors, points, stations } = hair;
  const out = new Float32Array(points.length);
  for (let place = 0; 3 * place < points.length; place++) {
    const anchor = 3 * (anchors[Math.floor(place / stations)] as number);
    for (let axis = 0; axis < 3; axis++) {
      const moved = carriedBy(hair, place, axis, generic, face);
      out[3 * place + axis] = (points[3 * place + axis] as number) + moved - (face[anchor + axis] as number);
    }
  }
  return out;
}

function carriedBy(hair: HairStrands, place: number, axis: number, generic: Float32Array, face: Float32Array): number {
  let sum = 0;
  for (let link = place * hair.links; link < (place + 1) * hair.links; link++) {
    const at = 3 * (hair.rows[link] as number) + axis;
    sum += (hair.weights[link] as number) * ((face[at] as number) - (generic[at] as number));
  }
  return sum;
}

/** Sums weight x offsets into `into`, four numbers a place, the last unused. */
export function mixOffsets(parts: readonly (readonly [Offsets, number])[], into: Float32Array): void {
  into.fill(0);
  for (const [offsets, weight] of parts)
    for (let place = 0; 3 * place < offsets.length; place++)
      for (let axis = 0; axis < 3; axis++) {
        const at = 4 * place + axis;
        into[at] = (into[at] as number) + weight * (offsets[3 * place + axis] as number);
      }
}

/** The weight at which a style is whole: before all faces wear it, so that no scalp is bare between two styles. */
export const FULL = 0.8;

/** How far a style has grown, 0..1, under the weight of the faces that wear it; rises with the weight, never jumps. */
export function grownAt(weight: number): number {
  const share = Math.min(1, Math.max(0, weight / FULL));
  return share * share * (3 - 2 * share);
}

/** The weight of every style, and of each face in it: of those faces that wear one. */
export function styleWeights(
  faces: ReadonlyMap<string, number>,
  styleOf: (face: string) => string,
): Map<string, Map<string, number>> {
  const styles = new Map<string, Map<string, number>>();
  for (const [face, weight] of faces) {
    const style = styleOf(face);
    if (style === "" || weight <= 0) continue;
    const wearers = styles.get(style) ?? new Map<string, number>();
    styles.set(style, wearers.set(face, weight));
  }
  return styles;
}
