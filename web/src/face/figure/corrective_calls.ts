/** How much of each corrective the joints of a figure call in a pose, as `model.body.correctives` has it. */

import {
  FINGER_BENDS,
  FINGERS,
  HINGE_BENDS,
  HINGES,
  HIP_BENDS,
  HIPS,
  SHAPES,
  SHOULDER_SHARES,
  SHOULDER_WAYS,
  SHOULDERS,
} from "../../link/constants";
import type { PosedBones } from "./kinematics";
import {
  cross,
  dot,
  inverse,
  length,
  minus,
  product,
  type Rotation,
  turnedBy,
  twistAbout,
  unit,
  type Vector,
} from "./rotations";
import { placeOf, type Skeleton } from "./skeleton";

const DEGREE = Math.PI / 180;

/** Writes how much of each corrective joints call (joints, SHAPES): elbows and knees, fingers, hips, shoulders. */
export function writeCalls(skeleton: Skeleton, bones: PosedBones, into: Float32Array): void {
  into.fill(0);
  const calls = [
    ...hingeBends(skeleton, bones.joints).map((bend) => between(bend, HINGE_BENDS)),
    ...FINGERS.map((finger) => between(fingerBend(skeleton, bones, finger), [0, ...FINGER_BENDS]).slice(1)),
    ...HIPS.map((hip) => between(hipBend(limbWay(skeleton, bones, hip, "root")), [0, ...HIP_BENDS]).slice(1)),
    ...SHOULDERS.map((shoulder) => shoulderCalls(shoulder, limbWay(skeleton, bones, shoulder, "spine01"))),
  ];
  calls.forEach((each, joint) => {
    into.set(each, SHAPES * joint);
  });
}

/** Between which knots an angle lies, as shares of them; beyond the last it stays there. */
function between(degrees: number, knots: readonly number[]): number[] {
  const shares = knots.map(() => 0);
  const next = knots.findIndex((knot) => degrees < knot);
  if (next <= 0) {
    shares[next < 0 ? knots.length - 1 : 0] = 1;
    return shares;
  }
  const [low, high] = [knots[next - 1] as number, knots[next] as number];
  shares[next] = (degrees - low) / (high - low);
  shares[next - 1] = 1 - (shares[next] as number);
  return shares;
}

/** How far each hinge is bent, degrees from the straight limb; `joints`: where bones begin. */
export const hingeBends = (skeleton: Skeleton, joints: readonly Vector[]): readonly number[] =>
  HINGES.map((names) => {
    const [begin, middle, end] = names.map((name) => joints[placeOf(skeleton, name)]) as [Vector, Vector, Vector];
    const [upper, lower] = [minus(middle, begin), minus(end, middle)];
    return Math.atan2(length(cross(upper, lower)), dot(upper, lower)) / DEGREE;
  });

function fingerBend(skeleton: Skeleton, { frames }: PosedBones, [before, bone]: readonly [string, string]): number {
  const [still, bent] = [before, bone].map((name) => frames[placeOf(skeleton, name)]) as [Rotation, Rotation];
  return (twistAbout(product(inverse(still), bent), [0, 0, -outOf(bone)]) / DEGREE) as number;
}

/** Where a limb points as its trunk has it. */
function limbWay(
  skeleton: Skeleton,
  { joints, frames }: PosedBones,
  [begin, end]: readonly [string, string],
  trunk: string,
): Vector {
  const way = minus(joints[placeOf(skeleton, end)] as Vector, joints[placeOf(skeleton, begin)] as Vector);
  return unit(turnedBy(inverse(frames[placeOf(skeleton, trunk)] as Rotation), way));
}

function hipBend([x, y, z]: Vector): number {
  const aside = Math.hypot(x, z);
  return ((Math.atan2(aside, -y) / DEGREE) * Math.max(z, 0)) / Math.max(aside, 1e-9);
}

function shoulderCalls([bone]: readonly [string, string], [x, y, z]: Vector): number[] {
  const way: Vector = [outOf(bone) * x, y, z];
  const angles = SHOULDER_WAYS.map((other) => Math.acos(Math.min(1, Math.max(-1, dot(way, other)))));
  return Array.from({ length: SHAPES }, (_, shape) =>
    angles.reduce((sum, angle, at) => sum + angle * (SHOULDER_SHARES[at]?.[shape] as number), 0),
  );
}

const outOf = (bone: string): number => (bone.endsWith("L") ? 1 : -1);
