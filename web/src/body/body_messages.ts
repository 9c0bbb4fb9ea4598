/** What the body's worker finds. */

import type { LookedAt } from "../face_mesh/landmark_messages";

/** Points of a body: the face's, then arms with hands, then legs; of pairs the left one first. */
export const BODY_POINTS = 33;
/** Numbers of a point: x, y, z in metres about the hips, how visible it is, x and y as fractions of the picture. */
export const BODY_NUMBERS = 6;
export const VISIBLE = 3;
export const PICTURE_X = 4;
export const PICTURE_Y = 5;

/** What is found of a body. */
export interface BodyFound {
  /** The numbers of each point, empty where no body is in the picture. */
  body: Float32Array<ArrayBuffer>;
}

/** A picture's body. */
export type Body = LookedAt & BodyFound;
