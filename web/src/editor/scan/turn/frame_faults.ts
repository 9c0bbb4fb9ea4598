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

/** Judges a picture by its landmarks and those of the picture before it, null where it is the first. */
export function judgeFrame(found: Landmarks, before: Landmarks | null): Judged {
  const bad = judgePicture(found).find(({ good }) => !good);
  if (bad !== undefined) return { fault: bad.what === "No face" ? bad.advice : `${bad.what}. ${bad.advice}` };
  const head = measureHead(found);
  const speed = before === null ? Number.POSITIVE_INFINITY : speedBetween(before, found);
  const wrong = FAULTS.find(([, is]) => is(head, speed, found));
  return wrong === undefined ? { fault: null, head, speed } : { fault: wrong[0] };
}

/** Sentences, and when they hold; the first counts. */
const FAULTS: readonly (readonly [string, (head: HeadMeasures, speed: number, found: Landmarks) => boolean])[] = [
  ["Too far: come nearer.", ({ height }, _, { width, height: tall }) => height < FAR * Math.min(width, tall)],
  ["Hold your head upright.", ({ roll }) => Math.abs(roll) > LEANS],
  ["Lower your chin a little.", ({ pitch }) => pitch > NODS],
  ["Raise your chin a little.", ({ pitch }) => pitch < -NODS],
  [HOLD, (_, speed) => speed === Number.POSITIVE_INFINITY], // it is not known yet whether it is
  ["Slower: the picture blurs while you move.", (_, speed) => speed > MOVING],
  ["Close your mouth.", ({ mouth }) => mouth > MOUTH_OPEN],
  ["Open your eyes.", ({ lids }) => lids < EYES_SHUT],
];

/** Of a picture whose face is not sharp. */
export const NOT_SHARP = "Not sharp: hold still, give your face more light, or wipe the lens.";
