/** A picture of how two shapes differ, drawn once on a plain canvas: how far each vertex moves, as heat. */

import type { Mesh } from "../../link/assets";

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

interface Facet {
  readonly corners: readonly [number, number, number];
  readonly depth: number;
  /** 0..1: how much it faces the light. */
  readonly light: number;
}

const LIGHT = [-0.35, 0.45, 0.82] as const;

/** The triangles that face the front, far ones first. */
export function facets(positions: Float32Array, meshes: readonly Mesh[]): Facet[] {
  const seen: Facet[] = [];
  for (const { source, triangles } of meshes)
    for (let at = 0; at < triangles.length; at += 3) {
      const corner = (one: number): number => 3 * (source[triangles[at + one] as number] as number);
      const facet = facetOf(positions, [corner(0), corner(1), corner(2)]);
      if (facet !== null) seen.push(facet);
    }
  return seen.sort((one, other) => one.depth - other.depth);
}

function facetOf(positions: Float32Array, corners: Facet["corners"]): Facet | null {
  const [a, b, c] = corners;
  const side = (to: number, axis: number): number => (positions[to + axis] as number) - (positions[a + axis] as number);
  const x = side(b, 1) * side(c, 2) - side(b, 2) * side(c, 1);
  const y = side(b, 2) * side(c, 0) - side(b, 0) * side(c, 2);
  const z = side(b, 0) * side(c, 1) - side(b, 1) * side(c, 0);
  if (z <= 0) return null; // its back, or nothing
  const light = Math.max(0, (x * LIGHT[0] + y * LIGHT[1] + z * LIGHT[2]) / Math.hypot(x, y, z));
  const depth = (positions[a + 2] as number) + (positions[b + 2] as number) + (positions[c + 2] as number);
  return { corners, depth, light };
}

/** What a picture shows: a window on the front of the head, metres. */
const FRAME = { x: 0, y: -0.012, height: 0.25 } as const;

/** Draws a shape; `colour` gives that of a row of the positions. */
export function drawShape(
  canvas: HTMLCanvasElement,
  positions: Float32Array,
  meshes: readonly Mesh[],
  colour: (row: number) => Colour,
): void {
  const context = canvas.getContext("2d");
  if (context === null) return;
  const { width, height } = canvas;
  const scale = height / FRAME.height;
  const x = (at: number): number => width / 2 + ((positions[at] as number) - FRAME.x) * scale;
  const y = (at: number): number => height / 2 - ((positions[at + 1] as number) - FRAME.y) * scale;
  context.fillStyle = "#0b0d0f";
  context.fillRect(0, 0, width, height);
  for (const { corners, light } of facets(positions, meshes)) {
    const shades = corners.map((at) => colour(at / 3));
    const shade = (part: 0 | 1 | 2): number =>
      Math.round((shades.reduce((sum, one) => sum + one[part], 0) / 3) * (0.25 + 0.75 * light));
    context.fillStyle = context.strokeStyle = `rgb(${shade(0)} ${shade(1)} ${shade(2)})`;
    context.beginPath();
    context.moveTo(x(corners[0]), y(corners[0]));
    context.lineTo(x(corners[1]), y(corners[1]));
    context.lineTo(x(corners[2]), y(corners[2]));
    context.closePath();
    context.fill();
    context.stroke(); // or the ground shows between two triangles
  }
}
