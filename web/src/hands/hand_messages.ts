/** What the hand's worker finds. */

import type { LookedAt } from "../face_mesh/landmark_messages";

/** Points of a hand: the wrist, then four of each finger, from the thumb to the little finger. */
export const HAND_POINTS = 21;

/** One hand in a picture. */
export interface FoundHand {
  /** x, y, z of each point: fractions of the picture's width and height, z in widths, smaller is nearer. */
  image: Float32Array<ArrayBuffer>;
  /** The same in metres, about the hand's middle. */
  world: Float32Array<ArrayBuffer>;
  /** Which hand the model takes it for. It expects mirrored pictures and is given what the camera sees, so this says the contrary of theirs. */
  side: "left" | "right";
  /** How sure the model is of that, 0..1. */
  score: number;
}

/** What is found of hands: none, one or two. */
export interface HandsFound {
  hands: FoundHand[];
}

/** A picture's hands. */
export type Hands = LookedAt & HandsFound;
