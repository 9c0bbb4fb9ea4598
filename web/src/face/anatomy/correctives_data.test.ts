import { describe, expect, it } from "vitest";
import { RUNGS } from "../../link/constants";
import type { CorrectivesDocument } from "../../link/messages";
import { readCorrectives, rolesOf } from "./correctives_data";

const bytes = (values: Uint32Array | Float32Array): Uint8Array =>
  new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
const whole = (...values: number[]): Uint8Array => bytes(Uint32Array.from(values));
const real = (...values: number[]): Uint8Array => bytes(Float32Array.from(values));

/** Four rows, two triangles, one line between rows 0 and 3, an eye around row 2, one follower. */
const document: CorrectivesDocument = {
  rounds: [12, 10, 10],
  least_area: 0.1,
  floor: 0.02,
  over_relaxation: 1.5,
  least_slope: 0.001,
  full: 0.05,
  momentum: 0.5,
  margin: 0.5,
  farthest: 0.03,
  bulge: 0.03,
  cornea: 0.6,
  deep: 0.4,
  kept: 0.3,
  sliver: 0,
  rows: whole(10, 20, 30, 40),
  triangles: whole(0, 1, 2, 1, 3, 2),
  crossings: [
    {
      upward: true,
      vertices: bytes(new Uint32Array(4 * RUNGS).fill(3)),
      weights: bytes(new Float32Array(4 * RUNGS).fill(0.5)),
      near: whole(0, 3),
      side: real(1, -1),
      share: real(0.25, 0.75),
    },
  ],
  lids: whole(2),
  eye: whole(1),
  patch_triangles: whole(0, 1, 1),
  patch_ends: whole(2, 3),
  row_patches: whole(0, 1, 0, 1, 0, 1, 1, 0),
  row_shares: real(1, 0, 0.5, 0.5, 0.75, 0.25, 1, 0),
  followers: whole(77),
  anchors: whole(1, 3),
  weights: real(0.75, 0.25),
};

describe("the data of correctives", () => {
  const correctives = readCorrectives(document);

  it("counts triangles, rungs and lids", () => {
    expect(correctives.size).toBe(2 + RUNGS + 1);
    const eyes = Array.from(correctives.rows, (_, place) =>
      Array.from(correctives.spans.slice(4 * place, 4 * place + 2)),
    );
    expect(eyes).toEqual([
      [0, 0],
      [0, 0],
      [2, 2 + RUNGS],
      [0, 0],
    ]);
  });

  it("gives each place its corners, the other two places in winding order", () => {
    const triangles = [
      [0, 1, 2],
      [1, 3, 2],
    ];
    const places = Array.from(correctives.rows, (_, place) => {
      const list: number[][] = [];
      const [first, end] = correctives.spans.slice(4 * place + 2, 4 * place + 4);
      for (let slot = first as number; slot < (end as number); slot++)
        list.push([place, ...correctives.corners.slice(4 * slot, 4 * slot + 3)]);
      return list;
    });
    for (const [a, b, c, triangle] of places.flat() as [number, number, number, number][]) {
      const own = triangles[triangle] as number[];
      const at = own.indexOf(a);
      expect([b, c]).toEqual([own[(at + 1) % 3], own[(at + 2) % 3]]);
    }
    expect(places.map((list) => list.length)).toEqual([1, 2, 2, 1]);
  });

  it("speaks of places", () => {
    expect(Array.from(correctives.triangles)).toEqual([0, 1, 2, 0, 1, 3, 2, 0]);
    expect(new Set(correctives.rungs)).toEqual(new Set([3]));
    expect(Array.from(correctives.anchors)).toEqual([1, 0.75, 3, 0.25]);
    expect(correctives.width).toBe(2);
  });

  it("tells every row of the positions what it is", () => {
    const roles = rolesOf(correctives, 80);
    const pairs = Array.from({ length: 80 }, (_, row) => [roles[2 * row], roles[2 * row + 1]]);
    expect([10, 20, 30, 40].map((row) => pairs[row])).toEqual([
      [1, 0],
      [2, 0],
      [3, 0],
      [4, 0],
    ]);
    expect(pairs[77]).toEqual([0, 1]);
    expect(pairs.flat().filter((role) => role !== 0)).toHaveLength(5);
  });

  it("knows which rows give way to which line", () => {
    expect(Array.from(correctives.pulls)).toEqual([0, 1, 0.25, 0, -1, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0.75, 0]);
    expect(Array.from(correctives.upward)).toEqual([1]);
  });

  it("is refused when it points past its rows", () => {
    expect(() => readCorrectives({ ...document, triangles: whole(0, 1, 4) })).toThrow(/point past its 4 rows/);
  });
});
