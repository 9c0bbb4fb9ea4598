/** The pose that a recipe describes, as `model.body.compose_pose` has it: joints in degrees as anatomy counts them. */

import type { Arm, Leg, PoseRecipe } from "../../link/editing_messages";
import { blankPose, type MixedPose } from "./pose_mix";
import { product, type Rotation, rotationOf, scaled, type Vector, vectorOf } from "./rotations";
import { placeOf, SIDES, type Skeleton } from "./skeleton";

const DEGREE = Math.PI / 180;
const SPINE_SHARES = { spine05: 0.15, spine04: 0.2, spine03: 0.2, spine02: 0.25, spine01: 0.2 };
const NECK_SHARES = { neck01: 0.2, neck02: 0.2, neck03: 0.2, head: 0.4 };
const FOREARM_SHARES = { lowerarm01: 0.15, lowerarm02: 0.55, wrist: 0.3 };
const FINGER_SHARES = [0.3, 0.42, 0.28];
const [FIST, THUMB_FIST, SPREAD] = [250, 110, 10];

type Put = (bone: string, vector: Vector) => void;
type Turn = PoseRecipe["turn"];

/** The pose that a recipe describes. */
export function poseOf(recipe: PoseRecipe, skeleton: Skeleton): MixedPose {
  const pose = blankPose(skeleton);
  const put: Put = (bone, vector) => {
    const first = 3 * placeOf(skeleton, bone);
    for (const axis of [0, 1, 2] as const)
      pose.turns[first + axis] = (pose.turns[first + axis] as number) + vector[axis];
  };
  put("root", bend(recipe.turn));
  for (const [shares, turn] of [
    [SPINE_SHARES, recipe.trunk],
    [NECK_SHARES, recipe.head],
  ] as const)
    for (const [bone, share] of Object.entries(shares)) put(bone, scaled(bend(turn), share));
  pose.travel.set(recipe.hips);
  for (const [number, side] of SIDES.entries()) {
    const [arm, leg] = side === "L" ? [recipe.left, recipe.left_leg] : [recipe.right, recipe.right_leg];
    const out = side === "L" ? 1 : -1;
    putArm(arm, out, (bone, vector) => put(`${bone}.${side}`, vector));
    putHand(arm, out, (bone, vector) => put(`${bone}.${side}`, vector));
    put(`upperleg01.${side}`, [0, out * DEGREE * leg.knee, 0]);
    put(`toes.${side}`, [-DEGREE * leg.toes, 0, 0]);
    pose.feet.set([out * leg.at[0], leg.at[1], leg.at[2]], 3 * number);
    pose.feetTurns.set(footTurn(leg.foot, out), 3 * number);
  }
  return pose;
}

/** Of a trunk, a neck or hips: forward about x, to the left about y, leant to the left about -z. */
function bend(turn: Turn): Vector {
  const [forward, left, lean] = turn;
  return together([0, DEGREE * left, 0], [DEGREE * forward, 0, -DEGREE * lean]);
}

/** One rotation vector after another. */
const together = (then: Vector, first: Vector): Vector =>
  vectorOf(product(rotationOf(then), rotationOf(first)) as Rotation);

function putArm(arm: Arm, out: number, put: Put): void {
  const [sideways, aside] = arm.wrist;
  put("clavicle", [0, -out * DEGREE * arm.reach, out * DEGREE * arm.shrug]);
  const swing: Vector = [-DEGREE * arm.raised, 0, out * DEGREE * arm.spread];
  put("upperarm01", together(swing, [0, -out * DEGREE * arm.twist, 0]));
  put("lowerarm01", [-DEGREE * arm.elbow, 0, 0]);
  for (const [bone, share] of Object.entries(FOREARM_SHARES)) put(bone, [0, -out * share * DEGREE * arm.forearm, 0]);
  put("wrist", [-DEGREE * aside, 0, -out * DEGREE * sideways]);
}

/** Fingers curl to the palm, which faces the thigh in the stand: about the axis ahead. */
function putHand({ curls, fan }: Arm, out: number, put: Put): void {
  for (const [number, curl] of curls.slice(1).entries()) {
    const finger = number + 2;
    for (const [joint, share] of FINGER_SHARES.entries())
      put(`finger${finger}-${joint + 1}`, [0, 0, -out * DEGREE * FIST * share * curl]);
    put(`finger${finger}-1`, [-DEGREE * SPREAD * fan * (3.5 - finger), 0, 0]);
  }
  const thumb = DEGREE * THUMB_FIST * curls[0];
  put("finger1-1", [0.3 * thumb, 0, -out * 0.2 * thumb]);
  put("finger1-2", [0.4 * thumb, 0, 0]);
  put("finger1-3", [0.5 * thumb, 0, 0]);
}

function footTurn(foot: Leg["foot"], out: number): Vector {
  const [up, outward, inner] = foot;
  return together([0, out * DEGREE * outward, 0], [-DEGREE * up, 0, out * DEGREE * inner]);
}
