/** Draws the points of a body over the camera's picture. */

import { BODY_NUMBERS, BODY_POINTS, type Body, PICTURE_X, PICTURE_Y, VISIBLE } from "./body_messages";

/** Points that make lines: the trunk, each arm with its hand, each leg. */
const LINES: readonly (readonly number[])[] = [
  [11, 12, 24, 23, 11],
  [11, 13, 15, 17, 19, 15, 21],
  [12, 14, 16, 18, 20, 16, 22],
  [23, 25, 27],
  [24, 26, 28],
];
/** The first point below the face, which its own model draws. */
const FIRST = 11;
/** Of visibility, 0..1: what is seen less plays nothing, and is drawn faintly. */
export const SEEN = 0.5;

/** Draws the body of one picture; the canvas keeps what else is on it. */
export function drawBody(context: CanvasRenderingContext2D, { body, width, height }: Body): void {
  if (body.length === 0) return;
  const number = (point: number, which: number): number => body[BODY_NUMBERS * point + which] ?? 0;
  const at = (point: number): [number, number] => [number(point, PICTURE_X) * width, number(point, PICTURE_Y) * height];
  const seen = (point: number): boolean => number(point, VISIBLE) >= SEEN;
  context.strokeStyle = context.fillStyle = "#f2b84b";
  context.lineWidth = Math.max(2, width / 240);
  for (const line of LINES) {
    for (let place = 1; place < line.length; place++) {
      const [from, to] = [line[place - 1] ?? 0, line[place] ?? 0];
      context.globalAlpha = seen(from) && seen(to) ? 1 : 0.25;
      context.beginPath();
      context.moveTo(...at(from));
      context.lineTo(...at(to));
      context.stroke();
    }
  }
  for (let point = FIRST; point < BODY_POINTS; point++) {
    context.globalAlpha = seen(point) ? 1 : 0.25;
    const [x, y] = at(point);
    context.fillRect(x - 2.5, y - 2.5, 5, 5);
  }
  context.globalAlpha = 1;
}
