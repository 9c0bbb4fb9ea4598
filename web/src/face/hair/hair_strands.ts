/** Strands of hair carried by the skin of a face, their mix, and how much of them shows. */

import { MathUtils, Vector3 } from "three";
import { STRETCH } from "../../link/constants";
import type { HairStrands } from "../../link/strands";

/** One style's strands on one face: metres from each strand's anchor, (strands x stations, 3). */
export type Offsets = Float32Array;

/**
 * The strands on a face, less their anchors, as `omote.model.hair.place_strands` has it: linear in the face's positions, so
 * that a mix of faces wears the mix of their hair, until a piece of a strand would change by more than STRETCH of its length.
 */
export function offsetsOn(hair: HairStrands, generic: Float32Array, face: Float32Array): Offsets {
  const { anchors, points, stations } = hair;
  const out = new Float32Array(points.length);
  const [moved, step] = [new Vector3(), new Vector3()];
  for (let place = 0; 3 * place < points.length; place++) {
    const root = place % stations === 0;
    for (let axis = 0; axis < 3; axis++) step.setComponent(axis, carriedBy(hair, place, axis, generic, face));
    if (root) moved.copy(step);
    else moved.add(step.sub(moved).clampLength(0, STRETCH * pieceBefore(points, place)));
    const anchor = 3 * (anchors[Math.floor(place / stations)] as number);
    for (let axis = 0; axis < 3; axis++)
      out[3 * place + axis] =
        (points[3 * place + axis] as number) + moved.getComponent(axis) - (face[anchor + axis] as number);
  }
  return out;
}

/**
 * A style as one face alone wears it, for `HAIR_VERTEX`: four numbers a place, beside the first three places of a strand
 * that all of its length and width is there, and how long it is (metres).
 */
export function fullStrands({ stations, points }: HairStrands, offsets: Offsets): Float32Array {
  const out = new Float32Array((4 * offsets.length) / 3);
  mixOffsets([[offsets, 1]], out);
  for (let root = 0; 3 * root < points.length; root += stations)
    [1, 1, strandLength(points, root, stations)].forEach((value, n) => {
      out[4 * (root + n) + 3] = value;
    });
  return out;
}

/** Metres along the strand that begins at a place. */
export function strandLength(points: Float32Array, first: number, stations: number): number {
  let sum = 0;
  for (let place = first + 1; place < first + stations; place++) sum += pieceBefore(points, place);
  return sum;
}

/** Metres from the place before to this one. */
function pieceBefore(points: Float32Array, place: number): number {
  const across = (axis: number): number =>
    (points[3 * place + axis] as number) - (points[3 * place - 3 + axis] as number);
  return Math.hypot(across(0), across(1), across(2));
}

function carriedBy(hair: HairStrands, place: number, axis: number, generic: Float32Array, face: Float32Array): number {
  let sum = 0;
  for (let link = place * hair.links; link < (place + 1) * hair.links; link++) {
    const at = 3 * (hair.rows[link] as number) + axis;
    sum += (hair.weights[link] as number) * ((face[at] as number) - (generic[at] as number));
  }
  return sum;
}

/** Sums weight x offsets into `into`, four numbers a place, the last untouched. */
export function mixOffsets(parts: readonly (readonly [Offsets, number])[], into: Float32Array): void {
  let begun = false;
  for (const [offsets, weight] of parts) {
    if (begun) addOffsets(offsets, weight, into);
    else setOffsets(offsets, weight, into);
    begun = true;
  }
}

function setOffsets(offsets: Offsets, weight: number, into: Float32Array): void {
  for (let [from, at] = [0, 0]; from < offsets.length; from += 3, at += 4) {
    into[at] = weight * (offsets[from] as number);
    into[at + 1] = weight * (offsets[from + 1] as number);
    into[at + 2] = weight * (offsets[from + 2] as number);
  }
}

function addOffsets(offsets: Offsets, weight: number, into: Float32Array): void {
  for (let [from, at] = [0, 0]; from < offsets.length; from += 3, at += 4) {
    into[at] = (into[at] as number) + weight * (offsets[from] as number);
    into[at + 1] = (into[at + 1] as number) + weight * (offsets[from + 1] as number);
    into[at + 2] = (into[at + 2] as number) + weight * (offsets[from + 2] as number);
  }
}

/** Ribbons that a sparse style keeps where few are drawn: fewer and wider ones would lie on a bald head like chips. */
const LEAST = 350;

/** How many of a style's strands are drawn where about this share of all ribbons is; the first ones cover the head. */
export function drawnStrands({ anchors }: HairStrands, share: number): number {
  return Math.max(1, Math.round(Math.min(anchors.length, Math.max(share * anchors.length, LEAST))));
}

/** The weights of the faces that have hair between which it grows to its whole length, where others have hair elsewhere and where they
 * have none. Shorter hair is a third style: it passes quickly, and late, when the hair has nearly the colour of what is under it. */
const [AMONG_HAIR, AMONG_BALD] = [
  [0.1, 0.3],
  [0.05, 0.22],
] as const;
/** Hair of this weight is whole on any mix. */
export const WHOLE_HAIR = AMONG_HAIR[1];

/** How long a strand is, 0..1 of its whole, under the weight of the faces that have hair there: never jumps. `bald`: the share, 0..1,
 * of those that wear none among all others. */
export const lengthAt = (weight: number, bald = 1): number =>
  MathUtils.smoothstep(
    weight,
    MathUtils.lerp(AMONG_HAIR[0], AMONG_BALD[0], bald),
    MathUtils.lerp(AMONG_HAIR[1], AMONG_BALD[1], bald),
  );

/** Of its weight, what a style has that came late, `share` (0..1) of its time after: it grows evenly in most of that time. */
export const weightOfLate = (share: number): number =>
  share < MOST
    ? MathUtils.lerp(AMONG_BALD[0], AMONG_BALD[1], share / MOST)
    : MathUtils.lerp(AMONG_BALD[1], 1, (share - MOST) / (1 - MOST));
const MOST = 0.8;

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
