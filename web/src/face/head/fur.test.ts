import { expect, it } from "vitest";
import { furRoots } from "./fur";

/** Five triangles of a square centimetre: on the crown, within the mouth, below the collar, on an ear, and on the lips. */
const SIDE = Math.sqrt(2e-4);
const BEGINNINGS = [
  [0, 0.1],
  [0, 0],
  [0, -0.16],
  [0.075, 0],
  [0, -0.06],
] as const;
const ROWS = 3 * BEGINNINGS.length;
const LIPS = [12, 13, 12, 14] as const;
const positions = Float32Array.from(BEGINNINGS.flatMap(([x, y]) => [x, y, 0, x + SIDE, y, 0, x, y + SIDE, 0]));
const rows = Uint32Array.from({ length: ROWS }, (_, row) => row);
const skin = {
  name: "skin",
  source: rows,
  uv: Float32Array.from({ length: 2 * ROWS }, (_, at) => positions[3 * (at >> 1) + (at & 1)] as number),
  triangles: rows,
  openness: new Uint8Array(ROWS),
};
const bag = Float32Array.from(rows, (row) => (Math.floor(row / 3) === 1 ? 0.001 : 0));
const traits = Float32Array.from({ length: 4 * ROWS }, (_, at) => (at % 4 === 0 ? 1 : 0));
const { rootRows, rootShares, flow, root } = furRoots(skin, { positions, traits, bag, lips: LIPS });
const strands = [...Array(root.length / 4).keys()];
const triangleOf = (strand: number) => Math.floor((rootRows[3 * strand] as number) / 3);

it("grows on skin, more on ears, and neither on lips, within the mouth nor under the collar", () => {
  const counts = [0, 1, 2, 3, 4].map((triangle) => strands.filter((strand) => triangleOf(strand) === triangle).length);
  expect(counts[0]).toBeGreaterThan(5);
  expect(counts[3]).toBeGreaterThan(2 * (counts[0] as number));
  expect([counts[1], counts[2], counts[4]]).toEqual([0, 0, 0]);
});

it("has each root on its triangle, the nearest row first, and its place on the pictures there", () => {
  for (const strand of strands) {
    const shares = rootShares.slice(3 * strand, 3 * strand + 3);
    expect(Math.min(...shares)).toBeGreaterThanOrEqual(0);
    expect(shares.reduce((sum, share) => sum + share)).toBeCloseTo(1, 12);
    expect(shares).toEqual([...shares].sort((a, b) => b - a));
    for (const axis of [0, 1]) {
      const place = shares.reduce((sum, share, n) => {
        return sum + share * (positions[3 * (rootRows[3 * strand + n] as number) + axis] as number);
      }, 0);
      expect(root[4 * strand + axis]).toBeCloseTo(place, 6);
    }
    expect(root[4 * strand + 2]).toBeCloseTo(1, 12);
  }
});

it("lies along its triangle, down and back from the muzzle, as long as it is painted", () => {
  for (const strand of strands) {
    const way = [0, 1, 2].map((axis) =>
      [0, 1, 2].reduce((sum, n) => {
        const row = rootRows[3 * strand + n] as number;
        return sum + (flow[3 * strand + n] as number) * (positions[3 * row + axis] as number);
      }, 0),
    );
    expect(way[2]).toBeCloseTo(0, 9);
    expect(Math.hypot(...way)).toBeGreaterThan(0.0039);
    expect(Math.hypot(...way)).toBeLessThan(0.0101);
    if (triangleOf(strand) === 3) expect(way[0]).toBeGreaterThan(0); // an ear's lies away from the midline
  }
});
