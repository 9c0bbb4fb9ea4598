/** The mix of bodies that a figure wears, and its bones below a face, as `perform.figures.figure` has them. */

import { FACES_OWN } from "../../link/constants";
import type { Body, FigureSpace } from "../../link/figures";
import { placeJoints, type RestingBones } from "./kinematics";
import { length, minus, ORIGIN, plus, scaled, type Vector } from "./rotations";
import { placeOf, SIDES, type Skeleton } from "./skeleton";
import { standTurns } from "./stand";

type Weights = Readonly<Record<string, number>>;

/** The mix of bodies by their own names; a face without a body of its name wears the first of `known`. */
export function mixedBodies(bodies: Weights, faces: Weights, known: readonly string[]): Map<string, number> {
  const mixed = new Map<string, number>();
  const add = (name: string, weight: number): void => {
    if (weight !== 0) mixed.set(name, (mixed.get(name) ?? 0) + weight);
  };
  const own = bodies[FACES_OWN] ?? 0;
  for (const [name, weight] of Object.entries(faces))
    add(known.includes(name) ? name : (known[0] as string), own * weight);
  for (const [name, weight] of Object.entries(bodies))
    if (name !== FACES_OWN) add(known.includes(name) ? name : (known[0] as string), weight);
  return mixed;
}

/** Where a face without expression carries its body: the middle of its rim, and the head's joint, metres. */
export interface NeckPlaces {
  readonly rim: Vector;
  readonly joint: Vector;
}

/** The places of a face's neck; `positions`: of its rows. */
export function neckPlaces(space: FigureSpace, positions: Float32Array): NeckPlaces {
  const mean = (rows: Uint32Array): Vector => {
    const sum = [0, 0, 0];
    for (const row of rows)
      for (const axis of [0, 1, 2]) sum[axis] = (sum[axis] as number) + (positions[3 * row + axis] as number);
    return scaled(sum as unknown as Vector, 1 / rows.length);
  };
  const { edge, rim, headJoint, headJointOffset } = space;
  return { rim: mean(edge.subarray(0, rim)), joint: plus(mean(headJoint), headJointOffset) };
}

/** Parts of things with their weights, which sum to one. */
export type Parts<T> = readonly (readonly [T, number])[];

/** The weighted sum of what bodies have at a place. */
export function bodySum(bodies: Parts<Body>, what: keyof Body, place: number): Vector {
  let sum = ORIGIN;
  for (const [body, weight] of bodies) {
    const values = body[what];
    const at = 3 * place;
    sum = plus(sum, scaled([values[at] as number, values[at + 1] as number, values[at + 2] as number], weight));
  }
  return sum;
}

/** The bones of a mix of bodies below a mix of faces, as modelled. */
export function restingBones(
  space: FigureSpace,
  skeleton: Skeleton,
  bodies: Parts<Body>,
  faces: Parts<NeckPlaces>,
): RestingBones {
  const faceSum = (what: keyof NeckPlaces): Vector =>
    faces.reduce<Vector>((sum, [face, weight]) => plus(sum, scaled(face[what], weight)), ORIGIN);
  let rim = ORIGIN;
  for (let place = 0; place < space.rim; place++) rim = plus(rim, bodySum(bodies, "edge", place));
  const shift = minus(faceSum("rim"), scaled(rim, 1 / space.rim));
  const joints = skeleton.names.map((_, bone) => plus(bodySum(bodies, "joints", bone), shift));
  const ends = skeleton.names.map((_, bone) => plus(bodySum(bodies, "ends", bone), shift));
  joints[placeOf(skeleton, "head")] = faceSum("joint");
  const stand = standTurns(skeleton, joints, ends);
  const standing = placeJoints(skeleton, joints, stand, joints[0] as Vector);
  return { joints, stand, standing, leg: legLength(skeleton, joints) };
}

/** Of thigh and shin, the mean of both sides, metres. */
function legLength(skeleton: Skeleton, joints: readonly Vector[]): number {
  const lengths = SIDES.map((side) => {
    const [hip, knee, ankle] = ["upperleg01", "lowerleg01", "foot"].map(
      (name) => joints[placeOf(skeleton, `${name}.${side}`)],
    ) as [Vector, Vector, Vector];
    return length(minus(knee, hip)) + length(minus(ankle, knee));
  });
  return ((lengths[0] as number) + (lengths[1] as number)) / 2;
}
