import { describe, expect, it } from "vitest";
import type { SettlingDocument } from "../link/messages";
import { RUNGS, readSettling } from "./settling";

const bytes = (values: Uint32Array | Float32Array): Uint8Array =>
  new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
const whole = (...values: number[]): Uint8Array => bytes(Uint32Array.from(values));
const real = (...values: number[]): Uint8Array => bytes(Float32Array.from(values));

/** Four rows, two triangles, one line between rows 0 and 3, an eye around row 2, one follower. */
const document: SettlingDocument = {
  rounds: 16,
  upright: 0.1,
  eager: 1.5,
  flattest: 0.001,
  bulge: 0.03,
  cornea: 0.6,
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
  followers: whole(77),
  anchors: whole(1, 3),
  weights: real(0.75, 0.25),
};

describe("a settling", () => {
  const settling = readSettling(document);

  it("counts triangles, rungs and lids", () => {
    expect(settling.size).toBe(2 + RUNGS + 1);
    expect(Array.from(settling.lids)).toEqual([-1, -1, -1, -1, 1, 2 + RUNGS, -1, -1]);
  });

  it("gives each row its corners, the other two rows in winding order", () => {
    const triangles = [
      [10, 20, 30],
      [20, 40, 30],
    ];
    const found = Array.from(settling.rows).map((row, place) => {
      const list: number[][] = [];
      for (let slot = settling.spans[2 * place] as number; slot < (settling.spans[2 * place + 1] as number); slot++)
        list.push([row, ...settling.corners.slice(4 * slot, 4 * slot + 3)]);
      return list;
    });
    for (const [a, b, c, triangle] of found.flat() as [number, number, number, number][]) {
      const own = triangles[triangle] as number[];
      const at = own.indexOf(a);
      expect([b, c]).toEqual([own[(at + 1) % 3], own[(at + 2) % 3]]);
    }
    expect(found.map((list) => list.length)).toEqual([1, 2, 2, 1]);
  });

  it("speaks of rows of the positions", () => {
    expect(Array.from(settling.triangles)).toEqual([10, 20, 30, 0, 20, 40, 30, 0]);
    expect(new Set(settling.rungRows)).toEqual(new Set([40]));
    expect(Array.from(settling.anchors)).toEqual([20, 0.75, 40, 0.25]);
    expect(settling.width).toBe(2);
  });

  it("knows which rows give way to which line", () => {
    expect(Array.from(settling.pulls)).toEqual([0, 1, 0.25, -1, 0, 0, -1, 0, 0, 0, -1, 0.75]);
    expect(Array.from(settling.upward)).toEqual([1]);
  });

  it("is refused when it points past its rows", () => {
    expect(() => readSettling({ ...document, triangles: whole(0, 1, 4) })).toThrow(/point past its 4 rows/);
  });
});
