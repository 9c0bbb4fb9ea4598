import { expect, it } from "vitest";
import { coarsened } from "./coarse";
import { patch } from "./patch";

const { positions, triangles } = patch();
const mesh = {
  name: "skin",
  source: Uint32Array.from({ length: 81 }, (_, n) => n),
  uv: new Float32Array(162),
  triangles,
};
const fineness = { kept: [40], around: 0.012, cell: 0.022, sky: () => 1 };

it("draws fewer triangles of the same rows, and all of those it is to keep", () => {
  const made = coarsened(mesh, positions, fineness);
  expect(made.triangles.length).toBeLessThan(triangles.length / 2);
  expect(made.triangles.length).toBeGreaterThan(0);
  const rows = new Set(made.source);
  for (const row of [40, 39, 41, 31, 49]) expect(rows.has(row)).toBe(true);
  expect(Math.max(...made.triangles)).toBeLessThan(made.source.length);
  expect(made.uv).toHaveLength(2 * made.source.length);
});

it("changes nothing where all is to be kept, and leaves out what no light reaches", () => {
  expect(coarsened(mesh, positions, { ...fineness, around: 1 }).triangles).toHaveLength(triangles.length);
  expect(coarsened(mesh, positions, { ...fineness, kept: [], sky: () => 0 }).triangles).toHaveLength(0);
});
