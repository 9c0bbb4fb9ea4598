import { describe, expect, it } from "vitest";
import type { Mesh } from "../../link/assets";
import { distances, heat, largest, largestSeen, lightOf, rasterized } from "./shape_difference";

const POSITIONS = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]);

it("rows are as far apart as they are", () => {
  const moved = POSITIONS.map((value, at) => (at === 4 ? value + 3 : at === 5 ? value + 4 : value));
  expect([...distances(POSITIONS, moved)]).toEqual([0, 5, 0]);
  expect(largest(distances(POSITIONS, moved))).toBe(5);
  expect(largest(distances(POSITIONS, POSITIONS))).toBe(0);
});

it("heat grows from grey to red and stays there", () => {
  expect(heat(-1)).toEqual(heat(0));
  expect(heat(2)).toEqual(heat(1));
  expect(heat(1)[0]).toBeGreaterThan(heat(0)[0]);
  expect(new Set([0, 0.33, 0.66, 1].map((share) => heat(share).join(" "))).size).toBe(4);
});

const mesh = (triangles: number[], rows: number): Mesh => ({
  name: "skin",
  source: Uint32Array.from({ length: rows }, (_, row) => row),
  uv: new Float32Array(2 * rows),
  triangles: Uint32Array.from(triangles),
  openness: new Uint8Array(rows),
});

/** A roof of two faces that fill the picture, its ridge upright in the middle. */
const ROOF = new Float32Array([-0.2, -0.2, 0, 0, -0.2, 0.1, 0, 0.2, 0.1, -0.2, 0.2, 0, 0.2, -0.2, 0, 0.2, 0.2, 0]);
const SIDES = mesh([0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2], 6);
const SIZE = 64;
const grey = () => [200, 200, 200] as const;
const reds = (
  meshes: readonly Mesh[],
  positions = ROOF,
  colour: (row: number) => readonly [number, number, number] = grey,
) => {
  const { pixels } = rasterized(SIZE, SIZE, positions, meshes, colour);
  return Array.from({ length: SIZE }, (_, column) => pixels[4 * ((SIZE / 2) * SIZE + column)] as number);
};

describe("the picture of a shape", () => {
  it("is lit smoothly over the edges of triangles", () => {
    const row = reds([SIDES]);
    const steps = row.slice(1).map((value, at) => Math.abs(value - (row[at] as number)));
    expect(Math.max(...row) - Math.min(...row)).toBeGreaterThan(20);
    expect(Math.max(...steps)).toBeLessThan(6); // two flat sides would meet in a jump
    expect(new Set(lightOf(ROOF, [SIDES])).size).toBeGreaterThan(2);
  });

  it("shows neither what faces away nor what is hidden, in whatever order it comes", () => {
    const behind = mesh([0, 2, 1, 0, 3, 2], 6);
    expect(new Set(reds([behind]))).toEqual(new Set([11]));
    const sheet = new Float32Array([-1, -1, 0, 1, -1, 0, 0, 1, 0, -1, -1, 0.1, 1, -1, 0.1, 0, 1, 0.1]);
    const [far, near] = [mesh([0, 1, 2], 6), mesh([3, 4, 5], 6)];
    const colour = (row: number) => (row < 3 ? ([0, 0, 0] as const) : ([250, 250, 250] as const));
    expect(reds([near, far], sheet, colour)).toEqual(reds([far, near], sheet, colour));
    expect(Math.min(...reds([near, far], sheet, colour))).toBeGreaterThan(100);
  });

  it("has no gap between triangles", () => {
    expect(Math.min(...reds([SIDES]))).toBeGreaterThan(20);
  });

  it("says how large numbers are where it shows them, not behind", () => {
    const sheet = new Float32Array([-1, -1, 0, 1, -1, 0, 0, 1, 0, -0.1, -0.1, 0.1, 0.1, -0.1, 0.1, 0, 0.1, 0.1]);
    const [far, near] = [mesh([0, 1, 2], 6), mesh([3, 4, 5], 6)];
    const hidden = new Float32Array([-0.01, -0.01, 0, 0.01, -0.01, 0, 0, 0.01, 0, ...sheet.slice(9)]);
    expect(largestSeen(Float32Array.of(9, 9, 9, 1, 2, 3), hidden, [far, near])).toBe(3);
    expect(largestSeen(Float32Array.of(9, 9, 9, 1, 2, 3), hidden, [far])).toBe(9);
    expect(largestSeen(Float32Array.of(9, 9, 9, 1, 2, 3), sheet, [])).toBe(0);
  });
});
