/** Draws the landmarks of hands over the camera's picture. */

import type { Hands } from "./hand_messages";

/** Rows of points that make lines: each finger from the wrist, and the knuckles. */
const LINES: readonly (readonly number[])[] = [
  [0, 1, 2, 3, 4],
  [0, 5, 6, 7, 8],
  [9, 10, 11, 12],
  [13, 14, 15, 16],
  [0, 17, 18, 19, 20],
  [5, 9, 13, 17],
];
/** The playing hand, and the other. */
const COLOURS = ["#3fd480", "#86b9ff"];

/** Draws the hands of one picture; playing: the place of the hand that plays, -1 for none. The canvas keeps what else is on it. */
export function drawHands(context: CanvasRenderingContext2D, { hands, width, height }: Hands, playing: number): void {
  context.lineWidth = Math.max(1.6, width / 320);
  hands.forEach(({ image }, place) => {
    const at = (row: number): [number, number] => [(image[3 * row] ?? 0) * width, (image[3 * row + 1] ?? 0) * height];
    context.strokeStyle = context.fillStyle = COLOURS[place === playing ? 0 : 1] ?? "";
    context.beginPath();
    for (const line of LINES) {
      line.forEach((row, index) => {
        const [x, y] = at(row);
        if (index === 0) context.moveTo(x, y);
        else context.lineTo(x, y);
      });
    }
    context.stroke();
    for (let row = 0; row < image.length / 3; row++) {
      const [x, y] = at(row);
      context.fillRect(x - 2, y - 2, 4, 4);
    }
  });
}
