/** What is wrong with a picture of the camera, in a sentence that says what to do. */

import { judgePicture } from "../../../face_mesh/face_health";
import type { Landmarks } from "../../../face_mesh/landmark_messages";
import { type HeadMeasures, measureHead, speedBetween } from "./head_measures";
import { HOLD } from "./turn_words";

/** Heights of the face a second from which on a picture is not taken. */
export const MOVING = 0.3;
/** Of the picture's shorter side: a smaller face has too few pixels for a skin. */
const FAR = 0.3;
/** Degrees that a head may lean, and look up or down: a screen lies below its camera. */
const [LEANS, NODS] = [18, 26];
/** Of heads of ours: lips at rest .03 at most, of a jaw a fifth open .05; lids at rest .23 at least, half shut .1 to .2. */
const [MOUTH_OPEN, EYES_SHUT] = [0.045, 0.14];
/** Below this a face is blurred, by motion or by the lens. */
export const BLURRED = 0.28;

/** Of a picture without a fault, what is known; of another, what to do. */
export type Judged = { readonly fault: string } | { readonly fault: null; readonly head: HeadMeasures; speed: number };

/**
 * Judges a picture by its landmarks and those of the picture before it, null where it is the first.
 *
 * The face is looked for where the picture before had it: of a dark one, or of a mouth that was open, this one's
 * landmarks still have something. So a picture is good as the second without a fault.
 */
export function judgeFrame(landmarks: Landmarks, before: Landmarks | null): Judged {
  const wrong = faultOfPicture(landmarks);
  if (wrong !== null) return { fault: wrong };
  const head = measureHead(landmarks);
  const speed = before === null ? Number.POSITIVE_INFINITY : speedBetween(before, landmarks);
  if (speed === Number.POSITIVE_INFINITY) return { fault: HOLD }; // it is not known yet whether it is still
  if (speed > MOVING) return { fault: "Slower: the picture blurs while you move." };
  const fault = faultOfFace(head) ?? (before !== null && hasFault(before) ? HOLD : null);
  return fault === null ? { fault, head, speed } : { fault };
}

/** What is wrong with a face, and where in the picture it is; it counts before its motion. */
function faultOfPicture(landmarks: Landmarks): string | null {
  const bad = judgePicture(landmarks).find(({ good }) => !good);
  if (bad !== undefined) return bad.what === "No face" ? bad.advice : `${bad.what}. ${bad.advice}`;
  const { height, roll, pitch } = measureHead(landmarks);
  if (height < FAR * Math.min(landmarks.width, landmarks.height)) return "Too far: come nearer.";
  if (Math.abs(roll) > LEANS) return "Hold your head upright.";
  if (pitch > NODS) return "Lower your chin a little.";
  return pitch < -NODS ? "Raise your chin a little." : null;
}

/** What is wrong with what the face does. */
function faultOfFace({ mouth, lids }: HeadMeasures): string | null {
  if (mouth > MOUTH_OPEN) return "Close your mouth.";
  return lids < EYES_SHUT ? "Open your eyes." : null;
}

const hasFault = (landmarks: Landmarks): boolean =>
  faultOfPicture(landmarks) !== null || faultOfFace(measureHead(landmarks)) !== null;

/** Of a picture whose face is not sharp. */
export const NOT_SHARP = "Not sharp: hold still, give your face more light, or wipe the lens.";
