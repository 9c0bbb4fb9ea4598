/** Draws the landmarks over the camera's picture: lips, lids, brows, irises, and a cloud of all points. */

import type { Landmarks } from "./landmark_messages";

/** Rows of points of the face mesh that make lines. */
const LINES: readonly (readonly number[])[] = [
  [61, 185, 40, 39, 37, 0, 267, 269, 270, 409, 291, 375, 321, 405, 314, 17, 84, 181, 91, 146, 61],
  [78, 191, 80, 81, 82, 13, 312, 311, 310, 415, 308, 324, 318, 402, 317, 14, 87, 178, 88, 95, 78],
  [33, 246, 161, 160, 159, 158, 157, 173, 133, 155, 154, 153, 145, 144, 163, 7, 33],
  [263, 466, 388, 387, 386, 385, 384, 398, 362, 382, 381, 380, 374, 373, 390, 249, 263],
  [70, 63, 105, 66, 107],
  [300, 293, 334, 296, 336],
  [469, 470, 471, 472, 469],
  [474, 475, 476, 477, 474],
];
const FIRST_IRIS = 468;

/** Draws one picture's landmarks into a canvas that lies over the picture, as large as it. */
export function drawLandmarks(canvas: HTMLCanvasElement, { points, width, height }: Landmarks): void {
  if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext("2d");
  if (context === null) return;
  context.clearRect(0, 0, width, height);
  if (points.length === 0) return;
  const at = (row: number): [number, number] => [(points[3 * row] ?? 0) * width, (points[3 * row + 1] ?? 0) * height];
  context.fillStyle = "#86b9ff";
  for (let row = 0; row < FIRST_IRIS; row++) {
    const [x, y] = at(row);
    context.fillRect(x - 0.6, y - 0.6, 1.2, 1.2);
  }
  context.strokeStyle = "#3fd480";
  context.lineWidth = Math.max(1.2, width / 420);
  context.beginPath();
  for (const line of LINES) {
    line.forEach((row, place) => {
      const [x, y] = at(row);
      if (place === 0) context.moveTo(x, y);
      else context.lineTo(x, y);
    });
  }
  context.stroke();
}
