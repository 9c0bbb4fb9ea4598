/** Which strand of another style is the same hair as a strand of this one. */

import { MathUtils, Vector3 } from "three";
import type { HairStrands } from "../../link/strands";
import { MIDDLE } from "./radial_map";

const [BEFORE, AFTER] = [new Vector3(), new Vector3()];

/** Metres between two roots up to which they are the same hair, and from which on they are not. */
const [SAME, OTHER] = [0.009, 0.018];
/** Radians, about: a strand that turns the same way by more is wound on a coil; waves turn to and fro. */
const WOUND = 3.2;

/**
 * How far round the head two courses may part: the cosine of half their angle about the skull's middle, from which on they
 * are the same hair combed otherwise, and below which their mean would lie inside the skull.
 */
const [TOGETHER, APART] = [0.85, 0.65];

/** For each strand of a style the nearest of another, and how far that one is the same hair, 0..1. */
export interface Matches {
  readonly strand: Int32Array;
  readonly same: Float32Array;
}

/** The strands of `to` that grow where those of `from` do and go about the same way. What is wound on a coil has no match. */
export function matchRoots(from: HairStrands, to: HairStrands): Matches {
  const count = from.anchors.length;
  const matches: Matches = { strand: new Int32Array(count), same: new Float32Array(count) };
  if (from.stations !== to.stations) return matches;
  const [own, other] = [woundStrands(from), woundStrands(to)];
  const grows = Array.from(to.anchors.keys()).filter((strand) => other[strand] === 0);
  for (let strand = 0; strand < count; strand++) {
    if (own[strand] === 1) continue;
    const [nearest, far] = nearestRoot(from, strand, to, grows);
    matches.strand[strand] = nearest;
    const near = MathUtils.smoothstep(OTHER - far, 0, OTHER - SAME);
    matches.same[strand] =
      near > 0 ? near * MathUtils.smoothstep(agreement(from, strand, to, nearest), APART, TOGETHER) : 0;
  }
  return matches;
}

function nearestRoot(from: HairStrands, strand: number, to: HairStrands, among: readonly number[]): [number, number] {
  const at = 3 * strand * from.stations;
  const [x, y, z] = [from.points[at] as number, from.points[at + 1] as number, from.points[at + 2] as number];
  let [nearest, least] = [0, Infinity];
  for (const other of among) {
    const root = 3 * other * to.stations;
    const across = (to.points[root] as number) - x;
    const up = (to.points[root + 1] as number) - y;
    const ahead = (to.points[root + 2] as number) - z;
    const far = across * across + up * up + ahead * ahead;
    if (far < least) [nearest, least] = [other, far];
  }
  return [nearest, Math.sqrt(least)];
}

/** The least cosine of half the angle between two strands, place by place, as seen from the skull's middle. */
function agreement(from: HairStrands, strand: number, to: HairStrands, other: number): number {
  const roots = [strand * from.stations, other * to.stations] as const;
  let least = 1;
  for (let place = 0; place < from.stations; place++) {
    const fromDirection = direction(from.points, roots[0] + place, BEFORE);
    const toDirection = direction(to.points, roots[1] + place, AFTER);
    least = Math.min(least, fromDirection.add(toDirection).length() / 2);
  }
  return least;
}

const direction = (points: Float32Array, place: number, into: Vector3): Vector3 =>
  into
    .fromArray(points, 3 * place)
    .sub(MIDDLE)
    .normalize();

/** 1 for each strand that is wound up, 0 for those that grow along the head. */
export function woundStrands({ anchors, points, stations }: HairStrands): Uint8Array {
  return Uint8Array.from(anchors, (_, strand) => {
    const turn = new Vector3();
    for (let place = strand * stations + 1; place + 1 < (strand + 1) * stations; place++)
      turn.add(piece(points, place, BEFORE).cross(piece(points, place + 1, AFTER)));
    return turn.length() > WOUND ? 1 : 0;
  });
}

/** The direction from the place before. */
function piece(points: Float32Array, place: number, into: Vector3): Vector3 {
  for (let axis = 0; axis < 3; axis++)
    into.setComponent(axis, (points[3 * place + axis] as number) - (points[3 * place - 3 + axis] as number));
  return into.normalize();
}
