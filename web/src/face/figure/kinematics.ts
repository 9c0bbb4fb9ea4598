/** Where the bones of a figure are in a pose, as `perform.figures.figure` has it. */

import { TWIST_SPREAD } from "../../link/constants";
import { reachFoot } from "./legs";
import type { MixedPose } from "./pose_mix";
import {
  inverse,
  minus,
  plus,
  product,
  type Rotation,
  rotationOf,
  scaled,
  turnedBy,
  twistAbout,
  unit,
  type Vector,
} from "./rotations";
import { LEG, placeOf, SIDES, type Skeleton } from "./skeleton";

/** Of the head's turn, how much each bone makes. */
const HEAD_SHARES = { head: 0.4, neck03: 0.2, neck02: 0.15, neck01: 0.1, spine01: 0.1, spine02: 0.05 };

/** A figure's bones before it is posed, metres: where they begin as modelled, their rotations to the stand, where they begin
 * there, and a leg's length. */
export interface RestingBones {
  readonly joints: readonly Vector[];
  readonly stand: readonly Rotation[];
  readonly standing: readonly Vector[];
  readonly leg: number;
}

/** Rotations of bones from the modelled pose, and from the stand; where they begin, metres. */
export interface PosedBones {
  readonly turns: readonly Rotation[];
  readonly joints: readonly Vector[];
  readonly frames: readonly Rotation[];
}

/**
 * Adds the head's own turn, a rotation vector, which neck and spine share; `tracked`: how much of a performer's trunk
 * shows, which has turned by itself, so that head and neck take so much of the spine's part.
 */
export function turnHead(skeleton: Skeleton, pose: MixedPose, head: Vector, tracked = 0): void {
  const ofSpine = (bone: string): boolean => bone.startsWith("spine");
  const neck = Object.entries(HEAD_SHARES).reduce((sum, [bone, share]) => sum + (ofSpine(bone) ? 0 : share), 0);
  for (const [bone, share] of Object.entries(HEAD_SHARES)) {
    const whole = ofSpine(bone) ? 0 : share / neck;
    for (const axis of [0, 1, 2] as const) {
      const at = 3 * placeOf(skeleton, bone) + axis;
      pose.turns[at] = (pose.turns[at] as number) + (share + tracked * (whole - share)) * head[axis];
    }
  }
}

const vectorAt = (values: Float64Array, place: number): Vector => [
  values[3 * place] as number,
  values[3 * place + 1] as number,
  values[3 * place + 2] as number,
];

/** The bones of a figure in a pose; its feet are where the pose puts them. */
export function poseFigure(skeleton: Skeleton, resting: RestingBones, pose: MixedPose): PosedBones {
  const { joints: rest, stand, standing, leg } = resting;
  const own = rest.map((_, bone) => rotationOf(vectorAt(pose.turns, bone)));
  const frames: Rotation[] = [];
  skeleton.parents.forEach((parent, bone) => {
    frames.push(parent < 0 ? (own[bone] as Rotation) : product(frames[parent] as Rotation, own[bone] as Rotation));
  });
  const placed = frames.map((frame, bone) => product(frame, stand[bone] as Rotation));
  const root = plus(rest[0] as Vector, scaled(vectorAt(pose.travel, 0), leg));
  const joints = placeJoints(skeleton, rest, placed, root);
  for (const [number, side] of SIDES.entries()) {
    const at = (name: string): number => placeOf(skeleton, `${name}.${side}`);
    const foot = at("foot");
    const target = plus(standing[foot] as Vector, scaled(vectorAt(pose.feet, number), leg));
    const [hip, knee] = [joints[at("upperleg01")], joints[at("lowerleg01")]] as [Vector, Vector];
    const ahead = turnedBy(frames[at("upperleg01")] as Rotation, [0, 0, 1]);
    const [thigh, shin] = reachFoot(hip, knee, joints[foot] as Vector, target, ahead);
    for (const name of LEG.slice(1, 3)) frames[at(name)] = product(thigh, frames[at(name)] as Rotation);
    for (const name of LEG.slice(3, 5)) frames[at(name)] = product(shin, frames[at(name)] as Rotation);
    frames[foot] = rotationOf(vectorAt(pose.feetTurns, number));
    frames[at("toes")] = product(frames[foot], own[at("toes")] as Rotation);
    for (const name of LEG.slice(1))
      placed[at(name)] = product(frames[at(name)] as Rotation, stand[at(name)] as Rotation);
  }
  spreadTwist(skeleton, resting, frames, placed);
  return { turns: placed, joints: placeJoints(skeleton, rest, placed, root), frames };
}

/** Upper arms twist less where they begin: their first bones turn back about themselves (`model.body.twist`). */
function spreadTwist(skeleton: Skeleton, { joints, stand }: RestingBones, frames: Rotation[], turns: Rotation[]): void {
  for (const side of SIDES) {
    const [before, first, second] = ["shoulder01", "upperarm01", "upperarm02"].map((name) =>
      placeOf(skeleton, `${name}.${side}`),
    ) as [number, number, number];
    const along = unit(minus(joints[second] as Vector, joints[first] as Vector));
    const turn = turns[first] as Rotation;
    const twist = twistAbout(product(inverse(turns[before] as Rotation), turn), along);
    turns[first] = product(turn, rotationOf(scaled(along, -TWIST_SPREAD * twist)));
    frames[first] = product(turns[first], inverse(stand[first] as Rotation));
  }
}

/** Where bones begin, each at the end of its parent, the first at `root`. */
export function placeJoints(
  { parents }: Skeleton,
  rest: readonly Vector[],
  turns: readonly Rotation[],
  root: Vector,
): Vector[] {
  const joints: Vector[] = [root];
  for (let bone = 1; bone < rest.length; bone++) {
    const parent = parents[bone] as number;
    const along = minus(rest[bone] as Vector, rest[parent] as Vector);
    joints.push(plus(joints[parent] as Vector, turnedBy(turns[parent] as Rotation, along)));
  }
  return joints;
}
