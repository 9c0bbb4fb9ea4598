/** The body of a performer whom a source sees, as `perform.figures.tracked_body` has it. */

import { POSE_REGIONS } from "../../link/constants";
import type { TrackedState } from "../../link/messages";
import { numbersOf } from "../pose/tracked_mix";
import type { MixedPose } from "./pose_mix";
import { regionOf, type Skeleton } from "./skeleton";

const TURN_STEP = 3.5 / 32767;
const PLACE_STEP = 3 / 32767;
const BESIDE_BONES = 15;

/** How much of a performer's trunk shows. */
export const trunkShare = (tracked: TrackedState | undefined): number =>
  tracked?.shares[POSE_REGIONS.indexOf("trunk")] ?? 0;

/** Puts a body in the place of what is called, by its shares: `(1 - share) pose + share tracked`, region by region. */
export function putTracked(tracked: TrackedState, { names }: Skeleton, pose: MixedPose): void {
  const view = numbersOf(tracked);
  if (view.byteLength !== 2 * (3 * names.length + BESIDE_BONES)) return; // of a cast with other bones
  const shareOf = (region: (typeof POSE_REGIONS)[number]): number => tracked.shares[POSE_REGIONS.indexOf(region)] ?? 0;
  const put = (into: Float64Array, at: number, number: number, step: number, share: number): void => {
    const now = into[at] as number;
    into[at] = now + share * (step * view.getInt16(2 * number, true) - now);
  };
  names.forEach((bone, place) => {
    const share = shareOf(regionOf(bone));
    if (share > 0) for (let at = 3 * place; at < 3 * place + 3; at++) put(pose.turns, at, at, TURN_STEP, share);
  });
  const stance = shareOf("stance");
  let number = 3 * names.length;
  for (const [into, step] of [
    [pose.travel, PLACE_STEP],
    [pose.feet, PLACE_STEP],
    [pose.feetTurns, TURN_STEP],
  ] as const)
    for (let at = 0; at < into.length; at++) put(into, at, number++, step, stance);
}
