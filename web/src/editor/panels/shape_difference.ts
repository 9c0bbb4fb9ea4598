/** A picture of how two shapes differ, drawn once on a plain canvas: how far each vertex moves, as heat. */

import type { Mesh } from "../../link/assets";
import type { Vector } from "../session/control_net";

/** How far each row of one shape is from the same row of another, metres. */
export function distances(a: Float32Array, b: Float32Array): Float32Array {
  const apart = new Float32Array(a.length / 3);
  for (let row = 0; row < apart.length; row += 1) {
    const at = 3 * row;
    const part = (axis: number): number => (a[at + axis] as number) - (b[at + axis] as number);
    apart[row] = Math.hypot(part(0), part(1), part(2));
  }
  return apart;
}

/** The largest of some numbers, 0 where there are none. */
export const largest = (values: Float32Array): number => values.reduce((most, value) => Math.max(most, value), 0);

type Colour = readonly [number, number, number];
const HEAT: readonly Colour[] = [
  [74, 80, 88],
  [46, 92, 190],
  [226, 196, 60],
  [255, 84, 50],
];
export const SKIN: Colour = [186, 160, 142];

/** The colour of a share 0..1: grey is nothing, then blue, yellow, red. */
export function heat(share: number): Colour {
  const at = Math.min(Math.max(share, 0), 1) * (HEAT.length - 1);
  const below = Math.min(Math.floor(at), HEAT.length - 2);
  const [low, high] = [HEAT[below] as Colour, HEAT[below + 1] as Colour];
  const mix = (part: 0 | 1 | 2): number => low[part] + (high[part] - low[part]) * (at - below);
  return [mix(0), mix(1), mix(2)];
}

const LIGHT = [-0.35, 0.45, 0.82] as const;
/** Light that comes to where none falls, as a share of all. */
const AROUND = 0.25;

/** How much each row faces the light, 0..1: by the area-weighted normal of the triangles around it. */
export function lightOf(positions: Float32Array, meshes: readonly Mesh[]): Float32Array {
  const normals = new Float32Array(positions.length);
  for (const { source, triangles } of meshes)
    for (let at = 0; at < triangles.length; at += 3) {
      const [a, b, c] = [0, 1, 2].map((n) => 3 * (source[triangles[at + n] as number] as number)) as Vector;
      const across = crossOf(positions, a, b, c);
      for (const corner of [a, b, c])
        for (const axis of [0, 1, 2] as const)
          normals[corner + axis] = (normals[corner + axis] as number) + across[axis];
    }
  return Float32Array.from({ length: positions.length / 3 }, (_, row) => {
    const part = (axis: 0 | 1 | 2): number => normals[3 * row + axis] as number;
    const along = part(0) * LIGHT[0] + part(1) * LIGHT[1] + part(2) * LIGHT[2];
    return Math.max(0, along / (Math.hypot(part(0), part(1), part(2)) || 1));
  });
}

/** The cross product of two sides of a triangle whose corners begin at these places: twice its area long. */
function crossOf(positions: Float32Array, a: number, b: number, c: number): [number, number, number] {
  const side = (to: number, axis: number): number => (positions[to + axis] as number) - (positions[a + axis] as number);
  return [
    side(b, 1) * side(c, 2) - side(b, 2) * side(c, 1),
    side(b, 2) * side(c, 0) - side(b, 0) * side(c, 2),
    side(b, 0) * side(c, 1) - side(b, 1) * side(c, 0),
  ];
}

/** How far before what is seen a row may lie and be seen itself, metres: more than a pixel's slope, less than a lip. */
const THIN = 0.0015;

/** The largest of numbers, one per row, among the rows that a picture of the shape shows; 0 where there is none. */
export function largestSeen(values: Float32Array, positions: Float32Array, meshes: readonly Mesh[]): number {
  const size = 256;
  const { depths } = rasterized(size, size, positions, meshes, () => SKIN);
  let most = 0;
  for (const { source } of meshes)
    for (const row of source) {
      const at = (axis: number): number => positions[3 * row + axis] as number;
      const column = Math.floor(size / 2 + ((at(0) - FRAME.x) * size) / FRAME.height);
      const line = Math.floor(size / 2 - ((at(1) - FRAME.y) * size) / FRAME.height);
      const inside = column >= 0 && column < size && line >= 0 && line < size;
      if (inside && at(2) > (depths[line * size + column] as number) - THIN)
        most = Math.max(most, values[row] as number);
    }
  return most;
}

/** What a picture shows: a window on the front of the head, metres. */
const FRAME = { x: 0, y: -0.012, height: 0.25 } as const;
const GROUND = [11, 13, 15] as const;
/** Pixels that are drawn for each of the picture's, along a side: they are then mixed, so that edges are smooth. */
export const FINER = 2;

/** Pixels from above, four bytes each, and how near each is, metres. */
interface Raster {
  readonly width: number;
  readonly height: number;
  readonly pixels: Uint8ClampedArray<ArrayBuffer>;
  readonly depths: Float32Array;
}

/** A corner of a triangle in a picture: place in pixels, how near, colour. */
type Corner = readonly [x: number, y: number, z: number, red: number, green: number, blue: number];

/** Draws a shape; `colour` gives that of a row of the positions. */
export function drawShape(
  canvas: HTMLCanvasElement,
  positions: Float32Array,
  meshes: readonly Mesh[],
  colour: (row: number) => Colour,
): void {
  const fine = new OffscreenCanvas(FINER * canvas.width, FINER * canvas.height);
  const { pixels } = rasterized(fine.width, fine.height, positions, meshes, colour);
  fine.getContext("2d")?.putImageData(new ImageData(pixels, fine.width, fine.height), 0, 0);
  const context = canvas.getContext("2d");
  if (context === null) return;
  context.imageSmoothingQuality = "high";
  context.drawImage(fine, 0, 0, canvas.width, canvas.height);
}

/** A shape in pixels: colours run smoothly from row to row (Gouraud 1971), what is near hides what is far. */
export function rasterized(
  width: number,
  height: number,
  positions: Float32Array,
  meshes: readonly Mesh[],
  colour: (row: number) => Colour,
): Raster {
  const raster = blank(width, height);
  const light = lightOf(positions, meshes);
  const scale = height / FRAME.height;
  const cornerOf = (row: number): Corner => {
    const lit = AROUND + (1 - AROUND) * (light[row] as number);
    const [red, green, blue] = colour(row).map((part) => part * lit) as [number, number, number];
    const at = (axis: number): number => positions[3 * row + axis] as number;
    return [width / 2 + (at(0) - FRAME.x) * scale, height / 2 - (at(1) - FRAME.y) * scale, at(2), red, green, blue];
  };
  for (const { source, triangles } of meshes) {
    const corners = Array.from(source, cornerOf);
    for (let at = 0; at < triangles.length; at += 3)
      fill(raster, ...([0, 1, 2].map((n) => corners[triangles[at + n] as number]) as [Corner, Corner, Corner]));
  }
  return raster;
}

function blank(width: number, height: number): Raster {
  const pixels = new Uint8ClampedArray(4 * width * height);
  for (let at = 0; at < pixels.length; at += 4) pixels.set([...GROUND, 255], at);
  return { width, height, pixels, depths: new Float32Array(width * height).fill(-Infinity) };
}

/** Fills a triangle that faces the front, pixel by pixel by its barycentric coordinates. */
function fill({ width, height, pixels, depths }: Raster, a: Corner, b: Corner, c: Corner): void {
  const area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  if (area >= 0) return; // its back, or nothing: rows of pixels run down
  const [left, right] = [Math.ceil(Math.min(a[0], b[0], c[0]) - 0.5), Math.floor(Math.max(a[0], b[0], c[0]) - 0.5)];
  const [top, bottom] = [Math.ceil(Math.min(a[1], b[1], c[1]) - 0.5), Math.floor(Math.max(a[1], b[1], c[1]) - 0.5)];
  for (let row = Math.max(0, top); row <= Math.min(height - 1, bottom); row += 1)
    for (let column = Math.max(0, left); column <= Math.min(width - 1, right); column += 1) {
      const [x, y] = [column + 0.5, row + 0.5];
      const ofB = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / area;
      const ofC = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / area;
      const ofA = 1 - ofB - ofC;
      if (ofA < 0 || ofB < 0 || ofC < 0) continue;
      const at = row * width + column;
      const depth = ofA * a[2] + ofB * b[2] + ofC * c[2];
      if (depth <= (depths[at] as number)) continue;
      depths[at] = depth;
      for (const part of [0, 1, 2] as const)
        pixels[4 * at + part] = ofA * a[(3 + part) as 3] + ofB * b[(3 + part) as 3] + ofC * c[(3 + part) as 3];
    }
}
