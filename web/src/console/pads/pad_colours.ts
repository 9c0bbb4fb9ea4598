/** The fields of a pad's looks as colours. */

import { type PadPlace, softBands } from "./blend_space";

type Colour = readonly [number, number, number];

/** What rests is grey. */
const REST: Colour = [46, 50, 56];
/** Degrees: the golden angle, so that looks that follow each other differ, however many there are. */
const TURN = 137.508;
/** Pictures of a square, each way; the screen draws them smooth. */
const FINE = 56;

/** The colour of a look by its place in the list; one at rest is grey. */
export function lookColour(at: number, rests: boolean): Colour {
  if (rests) return REST;
  const hue = (at * TURN + 20) % 360;
  const lightness = 0.34;
  const chroma = 0.5 * Math.min(lightness, 1 - lightness);
  const part = (from: number): number => {
    const k = (from + hue / 30) % 12;
    return Math.round(255 * (lightness - chroma * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [part(0), part(8), part(4)];
}

/** Draws the fields on a canvas: each point in the mixture of the colours of its looks. `depth`: where a third dimension is cut. */
export function drawFields(
  canvas: HTMLCanvasElement,
  places: readonly PadPlace[],
  colours: readonly Colour[],
  depth: number,
): void {
  const dimensions = places[0]?.length ?? 0;
  const context = canvas.getContext("2d");
  if (context === null || dimensions === 0) return;
  const [width, height] = [dimensions === 1 ? 4 * FINE : FINE, dimensions === 1 ? 1 : FINE];
  [canvas.width, canvas.height] = [width, height];
  const picture = context.createImageData(width, height);
  for (let row = 0; row < height; row += 1)
    for (let column = 0; column < width; column += 1) {
      const point = [(2 * column + 1) / width - 1, 1 - (2 * row + 1) / height, depth].slice(0, dimensions);
      picture.data.set(mixed(softBands(places, point), colours), 4 * (row * width + column));
    }
  context.putImageData(picture, 0, 0);
}

function mixed(weights: readonly number[], colours: readonly Colour[]): [number, number, number, number] {
  const sum: [number, number, number, number] = [0, 0, 0, 255];
  for (const [at, weight] of weights.entries())
    for (const part of [0, 1, 2] as const) sum[part] += weight * ((colours[at] as Colour)[part] as number);
  return sum;
}
