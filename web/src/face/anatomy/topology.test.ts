import { describe, expect, it } from "vitest";
import { distances, fans, lowestBorder, normalAt, smoothed } from "./topology";

/** An open-bottomed roof: four corners below, an apex above, wound so that it faces outwards. */
const roof = {
  positions: Float32Array.from([1, 0, 1, 1, 0, -1, -1, 0, -1, -1, 0, 1, 0, 1, 0]),
  triangles: Uint32Array.from([0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4]),
};
const around = fans([roof.triangles], 5);

describe("fans", () => {
  it("hold each triangle at each of its corners, in winding order", () => {
    expect(Array.from(around.starts)).toEqual([0, 2, 4, 6, 8, 12]);
    for (let row = 0; row < 5; row++)
      for (let slot = around.starts[row] as number; slot < (around.starts[row + 1] as number); slot++) {
        const turn = [row, around.pairs[2 * slot], around.pairs[2 * slot + 1]];
        const inside = [0, 3, 6, 9].some((at) => {
          const list = Array.from(roof.triangles.slice(at, at + 3));
          return [0, 1, 2].some((shift) => [0, 1, 2].every((n) => list[(n + shift) % 3] === turn[n]));
        });
        expect(inside).toBe(true);
      }
  });
});

describe("the normal of a row", () => {
  it("is up on the apex of a roof, also of positions with four numbers a row", () => {
    expect(normalAt(around, roof.positions, 4)).toEqual([0, 1, 0]);
    const wide = Float32Array.from({ length: 20 }, (_, at) =>
      at % 4 < 3 ? (roof.positions[3 * (at >> 2) + (at % 4)] as number) : 1,
    );
    expect(normalAt(around, wide, 4, 4)).toEqual([0, 1, 0]);
    expect(normalAt(around, roof.positions, 0)[1]).toBeGreaterThan(0);
  });
});

describe("the border", () => {
  it("is the loop around the lowest point, walked once", () => {
    const loop = lowestBorder(roof.triangles, roof.positions);
    expect([...loop].sort()).toEqual([0, 1, 2, 3]);
  });

  it("is empty where the mesh is closed", () => {
    const closed = Uint32Array.from([...roof.triangles, 0, 3, 1, 1, 3, 2]);
    expect(lowestBorder(closed, roof.positions)).toEqual([]);
  });
});

describe("distances", () => {
  it("run along the edges", () => {
    const far = distances(around, roof.positions, [0]);
    expect(Array.from(far)).toEqual(
      [0, 2, 4, 2, Math.sqrt(3)].map((value, row) => expect.closeTo(row === 2 ? 2 * Math.sqrt(3) : value, 5)),
    );
  });
});

describe("smoothing", () => {
  it("keeps what is the same everywhere and stays between the extremes", () => {
    expect(Array.from(smoothed(around, new Float32Array(5).fill(3), 1, 4))).toEqual([3, 3, 3, 3, 3]);
    for (const value of smoothed(around, Float32Array.from([0, 1, 0, 1, 5]), 1, 3)) {
      expect(value).toBeGreaterThan(0);
      expect(value).toBeLessThan(5);
    }
  });
});
