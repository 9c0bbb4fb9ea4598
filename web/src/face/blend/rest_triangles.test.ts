import { describe, expect, it } from "vitest";
import { areaLeft, restTriangles } from "./rest_triangles";

/** A right-angled triangle, one long and two high, somewhere in space. */
const points = Float64Array.from([1, 1, 3, 2, 1, 3, 1, 3, 3]);
const triangles = Uint32Array.from([0, 1, 2, 0]);
const rest = restTriangles(points, triangles);

describe("triangles at rest", () => {
  it("have normals twice their areas long", () => {
    expect(Array.from(rest.normals)).toEqual([0, 0, 2]);
    expect(Array.from(rest.sizes)).toEqual([4]);
  });

  it("keep all of their area where nothing moves, and less than none turned over", () => {
    expect(areaLeft(points, triangles, rest, 0)).toBe(1);
    const moved = points.slice();
    moved[3] = 1 - 0.25; // through the opposite side
    expect(areaLeft(moved, triangles, rest, 0)).toBe(-0.25);
    moved[3] = 1;
    expect(areaLeft(moved, triangles, rest, 0)).toBe(0);
  });
});
