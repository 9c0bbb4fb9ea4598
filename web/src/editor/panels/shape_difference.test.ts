import { expect, it } from "vitest";
import type { Mesh } from "../../link/assets";
import { distances, facets, heat, largest } from "./shape_difference";

const MESH: Mesh = {
  name: "skin",
  source: new Uint32Array([0, 1, 2, 3, 4, 5]),
  uv: new Float32Array(12),
  triangles: new Uint32Array([0, 1, 2, 3, 4, 5, 0, 2, 1]),
};
// two triangles that face the front, the second nearer
const POSITIONS = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1]);

it("rows are as far apart as they are", () => {
  const moved = POSITIONS.map((value, at) => (at === 4 ? value + 3 : at === 5 ? value + 4 : value));
  expect([...distances(POSITIONS, moved)]).toEqual([0, 5, 0, 0, 0, 0]);
  expect(largest(distances(POSITIONS, moved))).toBe(5);
  expect(largest(distances(POSITIONS, POSITIONS))).toBe(0);
});

it("what faces away is not drawn, and what is near is drawn last", () => {
  expect(facets(POSITIONS, [MESH]).map(({ corners }) => corners[0])).toEqual([0, 9]);
});

it("heat grows from grey to red and stays there", () => {
  expect(heat(-1)).toEqual(heat(0));
  expect(heat(2)).toEqual(heat(1));
  expect(heat(1)[0]).toBeGreaterThan(heat(0)[0]);
  expect(new Set([0, 0.33, 0.66, 1].map((share) => heat(share).join(" "))).size).toBe(4);
});
