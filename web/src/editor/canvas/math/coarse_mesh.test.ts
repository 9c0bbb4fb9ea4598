import { expect, it } from "vitest";
import { patch } from "../model/skin_patch";
import { coarsened } from "./coarse_mesh";

const { positions, triangles } = patch();
const mesh = {
  name: "skin",
  source: Uint32Array.from({ length: 81 }, (_, n) => n),
  uv: new Float32Array(162),
  triangles,
  openness: Uint8Array.from({ length: 81 }, (_, n) => n),
};
const fineness = { lines: [40], around: 0.012, near: 1e-5, cell: 0.022, sky: () => 1 };

it("draws fewer triangles of the same rows, and those around lines in their own cells", () => {
  const coarse = coarsened(mesh, positions, fineness);
  expect(coarse.triangles.length).toBeLessThan(triangles.length / 2);
  expect(coarse.triangles.length).toBeGreaterThan(0);
  const rows = new Set(coarse.source);
  for (const row of [40, 39, 41, 31, 49]) expect(rows.has(row)).toBe(true);
  expect(Math.max(...coarse.triangles)).toBeLessThan(coarse.source.length);
  expect(coarse.uv).toHaveLength(2 * coarse.source.length);
  expect(coarse.openness).toHaveLength(coarse.source.length);
});

it("changes nothing where cells hold one row, and closes what no light reaches by few triangles", () => {
  expect(coarsened(mesh, positions, { ...fineness, cell: 1e-5 }).triangles).toHaveLength(triangles.length);
  const inside = coarsened(mesh, positions, { ...fineness, lines: [], cell: 1e-5, sky: () => 0 }).triangles;
  expect(inside.length).toBeGreaterThan(0); // without it one looks through an open mouth, out at the back of the head
  expect(inside.length).toBeLessThan(triangles.length);
});

it("keeps apart what lies in one place but hangs together nowhere: lips that touch", () => {
  const count = positions.length / 3;
  const twice = Float32Array.from([...positions, ...positions]);
  const both = {
    name: "skin",
    source: Uint32Array.from({ length: 2 * count }, (_, n) => n),
    uv: new Float32Array(4 * count),
    triangles: Uint32Array.from([...triangles, ...triangles.map((corner) => corner + count)]),
    openness: new Uint8Array(2 * count),
  };
  const coarse = coarsened(both, twice, { ...fineness, lines: [] });
  for (let at = 0; at < coarse.triangles.length; at += 3) {
    const sides = new Set([0, 1, 2].map((n) => (coarse.source[coarse.triangles[at + n] as number] as number) >= count));
    expect(sides.size).toBe(1);
  }
  expect(coarse.triangles.length).toBe(2 * coarsened(mesh, positions, { ...fineness, lines: [] }).triangles.length);
});
