/**
 * How sharp the face in a picture is, without another picture to hold it against (F. Crete, T. Dolmiere, P. Ladret and
 * M. Nicolas, "The blur effect: perception and estimation with a new no-reference perceptual blur metric", 2007):
 * what is blurred once more loses much where it was sharp, and little where it was blurred already.
 */

import { faceBox } from "../../../face_mesh/face_light";

/** Pixels a side of what is looked at: more say nothing more. */
const SIDE = 256;
/** Pixels on either side that it is blurred over. */
const REACH = 4;
/** Of the face's box, the middle: eyes, nose and mouth, nothing behind the head. */
const MIDDLE = 0.7;

/** The light of a picture (n = width times rows), row by row. */
export interface Grey {
  readonly values: Float32Array;
  readonly width: number;
  readonly rows: number;
}

/** 0..1: 0 is flat or quite blurred; along the axis along which it is less. */
export const sharpnessOf = (grey: Grey): number => Math.min(alongRows(grey), alongRows(turned(grey)));

/** How much of the differences between neighbours a blur along the rows takes away. */
function alongRows({ values, width, rows }: Grey): number {
  let [all, lost] = [0, 0];
  for (let row = 0; row < rows; row++) {
    const blurred = blur(values.subarray(row * width, (row + 1) * width));
    for (let x = 1; x < width; x++) {
      const place = row * width + x;
      const now = Math.abs((values[place] as number) - (values[place - 1] as number));
      const then = Math.abs((blurred[x] as number) - (blurred[x - 1] as number));
      all += now;
      lost += Math.max(0, now - then);
    }
  }
  return all === 0 ? 0 : lost / all;
}

/** A row, each value the mean of those around it; at the ends of fewer. */
function blur(row: Float32Array): Float32Array {
  const sums = new Float64Array(row.length + 1);
  for (let x = 0; x < row.length; x++) sums[x + 1] = (sums[x] as number) + (row[x] as number);
  return row.map((_, x) => {
    const [first, last] = [Math.max(0, x - REACH), Math.min(row.length, x + REACH + 1)];
    return ((sums[last] as number) - (sums[first] as number)) / (last - first);
  });
}

const turned = ({ values, width, rows }: Grey): Grey => ({
  values: values.map((_, place) => values[(place % rows) * width + Math.floor(place / rows)] as number),
  width: rows,
  rows: width,
});

let canvas: OffscreenCanvasRenderingContext2D | null = null;

/** The light of the middle of a face, as the camera gave it where that is no larger than `SIDE`. */
export function greyOfFace(picture: ImageBitmap, points: Float32Array): Grey {
  const [left, top, wide, high] = faceBox(points, picture.width, picture.height);
  const [width, rows] = [wide, high].map((size) => Math.max(1, Math.round(Math.min(SIDE, MIDDLE * size)))) as [
    number,
    number,
  ];
  canvas ??= new OffscreenCanvas(SIDE, SIDE).getContext("2d", { willReadFrequently: true });
  const edge = (1 - MIDDLE) / 2;
  canvas?.drawImage(picture, left + edge * wide, top + edge * high, MIDDLE * wide, MIDDLE * high, 0, 0, width, rows);
  const pixels = canvas?.getImageData(0, 0, width, rows).data ?? new Uint8ClampedArray();
  const values = Float32Array.from({ length: width * rows }, (_, place) => lumaAt(pixels, 4 * place));
  return { values, width, rows };
}

const lumaAt = (pixels: Uint8ClampedArray, place: number): number =>
  0.2126 * (pixels[place] ?? 0) + 0.7152 * (pixels[place + 1] ?? 0) + 0.0722 * (pixels[place + 2] ?? 0);
