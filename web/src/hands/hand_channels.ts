/** What a hand plays: its opening is the jaw, its wrist the head, its curls two-way channels. */

import type { HandAxes } from "./hand_guide";

/** Channels of a two-way control: where the finger is lifted, and where it is bent. */
const LIFTED = {
  index: ["browInnerUp", "browOuterUpLeft", "browOuterUpRight"],
  little: ["mouthSmileLeft", "mouthSmileRight"],
} as const;
const BENT = {
  index: ["browDownLeft", "browDownRight"],
  little: ["mouthFrownLeft", "mouthFrownRight"],
} as const;
/** Radians of the head at the farthest turn of the guided minute. */
const HEAD_TURN = (28 * Math.PI) / 180;

/** What a frame of the hand says to the show. */
export interface PlayedHand {
  weights: Record<string, number>;
  head: [number, number, number];
}

/** The weights and the head of a hand. */
export function playHand({ opening, index, little, yaw, pitch, roll }: HandAxes): PlayedHand {
  const curls = { index, little };
  const weights: Record<string, number> = { jawOpen: opening };
  for (const finger of ["index", "little"] as const) {
    for (const name of LIFTED[finger]) weights[name] = Math.max(0, -curls[finger]);
    for (const name of BENT[finger]) weights[name] = Math.max(0, curls[finger]);
  }
  return { weights, head: [HEAD_TURN * yaw, HEAD_TURN * pitch, HEAD_TURN * roll] };
}
