/** Writes a body's points as the show reads them: one binary message a picture, little endian. */

import { BODY_NUMBERS, type Body } from "../../body/body_messages";

const MAGIC = "OMBL";
const VERSION = 1;
const HEAD = 20;

/** The message of a picture's body; the picture is as the camera gives it, not mirrored. */
export function writeBodyFrame({ time, width, height, body }: Body): ArrayBuffer {
  const message = new ArrayBuffer(HEAD + 4 * body.length);
  const view = new DataView(message);
  for (let place = 0; place < MAGIC.length; place++) view.setUint8(place, MAGIC.charCodeAt(place));
  view.setUint16(4, VERSION, true);
  view.setUint16(6, width, true);
  view.setUint16(8, height, true);
  view.setUint16(10, body.length / BODY_NUMBERS, true);
  view.setFloat64(12, time, true);
  body.forEach((value, place) => {
    view.setFloat32(HEAD + 4 * place, value, true);
  });
  return message;
}
