/** How light a picture is around the face. */

/** Pixels a side that are looked at: enough for a mean. */
const SIDE = 16;
let canvas: OffscreenCanvasRenderingContext2D | null = null;

/** The mean light of a picture within the box of the points, or of all of it where there are none; 0..1. */
export function faceLight(picture: ImageBitmap, points: Float32Array): number {
  canvas ??= new OffscreenCanvas(SIDE, SIDE).getContext("2d", { willReadFrequently: true });
  if (canvas === null) return 1;
  const [left, top, width, height] = faceBox(points, picture.width, picture.height);
  canvas.drawImage(picture, left, top, width, height, 0, 0, SIDE, SIDE);
  return meanLight(canvas.getImageData(0, 0, SIDE, SIDE).data);
}

/** The box of points within a picture: left, top, width and height, pixels. */
export function faceBox(points: Float32Array, width: number, height: number): [number, number, number, number] {
  if (points.length === 0) return [0, 0, width, height];
  let [left, top, right, bottom] = [1, 1, 0, 0];
  for (let place = 0; place < points.length; place += 3) {
    left = Math.min(left, points[place] ?? 1);
    right = Math.max(right, points[place] ?? 0);
    top = Math.min(top, points[place + 1] ?? 1);
    bottom = Math.max(bottom, points[place + 1] ?? 0);
  }
  const inside = (value: number): number => Math.min(Math.max(value, 0), 1);
  const [x, y] = [inside(left) * width, inside(top) * height];
  return [x, y, Math.max(inside(right) * width - x, 1), Math.max(inside(bottom) * height - y, 1)];
}

/** The mean luma of pixels of four bytes, 0..1. */
export function meanLight(pixels: Uint8ClampedArray): number {
  let sum = 0;
  for (let place = 0; place < pixels.length; place += 4) {
    sum += 0.2126 * (pixels[place] ?? 0) + 0.7152 * (pixels[place + 1] ?? 0) + 0.0722 * (pixels[place + 2] ?? 0);
  }
  return pixels.length ? (4 * sum) / pixels.length / 255 : 0;
}
