/** Writes landmarks as the show reads them: one binary message a picture, little endian. */

import type { Landmarks } from "../../face_mesh/landmark_messages";

const MAGIC = "OMLM";
const VERSION = 1;
const HEAD = 20;

/** The message of a picture's landmarks; the picture is as the camera gives it, not mirrored. */
export function writeLandmarkFrame(landmarks: Landmarks): ArrayBuffer {
  const count = landmarks.points.length / 3;
  const message = new ArrayBuffer(HEAD + 4 * landmarks.points.length);
  const view = new DataView(message);
  for (let place = 0; place < MAGIC.length; place++) view.setUint8(place, MAGIC.charCodeAt(place));
  view.setUint16(4, VERSION, true);
  view.setUint16(6, landmarks.width, true);
  view.setUint16(8, landmarks.height, true);
  view.setUint16(10, count, true);
  view.setFloat64(12, landmarks.time, true);
  landmarks.points.forEach((value, place) => {
    view.setFloat32(HEAD + 4 * place, value, true);
  });
  return message;
}
