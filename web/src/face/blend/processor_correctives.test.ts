import { describe, expect, it } from "vitest";
import { RUNGS } from "../../link/constants";
import type { CorrectivesDocument } from "../../link/messages";
import { readCorrectives } from "../anatomy/correctives_data";
import type { Sockets } from "./corrective_passes";
import { ProcessorCorrectives } from "./processor_correctives";

const bytes = (values: Uint32Array | Float32Array): Uint8Array =>
  new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
const whole = (...values: number[]): Uint8Array => bytes(Uint32Array.from(values));
const real = (...values: number[]): Uint8Array => bytes(Float32Array.from(values));

/** A square of two triangles; between rows 0 and 2 a line that opens upward; row 3 is a lid; row 4 follows row 1 by half. */
const document: CorrectivesDocument = {
  rounds: [8, 8, 8],
  least_area: 0.1,
  floor: 0.02,
  over_relaxation: 1.5,
  least_slope: 0.001,
  full: 0.05,
  momentum: 0.5,
  margin: 0.5,
  farthest: 0.03,
  bulge: 0,
  cornea: 0.6,
  deep: 0.4,
  kept: 0.3,
  sliver: 0,
  rows: whole(0, 1, 2, 3),
  triangles: whole(0, 1, 2, 0, 2, 3),
  crossings: [
    {
      upward: true,
      vertices: bytes(new Uint32Array(4 * RUNGS).map((_, at) => [2, 0, 0, 0][at % 4] as number)),
      weights: bytes(new Float32Array(4 * RUNGS).map((_, at) => [1, -1, 0, 0][at % 4] as number)),
      near: whole(0, 2),
      side: real(-1, 1),
      share: real(0.5, 0.5),
    },
  ],
  lids: whole(3),
  eye: whole(0),
  patch_triangles: whole(0, 1),
  patch_ends: whole(2),
  row_patches: whole(0, 0, 0, 0),
  row_shares: real(1, 1, 1, 1),
  followers: whole(4),
  anchors: whole(1),
  weights: real(0.5),
};
const data = readCorrectives(document);
const corrected = new ProcessorCorrectives(data);
const square = Float64Array.from([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, -1]);
const rest = corrected.rested(square);
const sockets: Sockets = {
  centres: Float32Array.from([0, 9, 0, 0, 9, 0]),
  radii: Float32Array.from([1, 1]),
  sights: Float32Array.from([0, 0, 1, 0, 0, 1]),
};
const none = new Float32Array(data.size);

/** The square with some numbers replaced, corrected. */
function correct(moved: Readonly<Record<number, number>>, allowed = none, eyes = sockets): Float64Array {
  const positions = square.slice();
  for (const [place, value] of Object.entries(moved)) positions[Number(place)] = value;
  corrected.correct(positions, rest, allowed, eyes);
  return positions;
}
const shares = (positions: Float64Array): number[] =>
  [0, 1].map((t) => corrected.areaShare(positions.subarray(0, 12), rest, t));

describe("correctives on the processor", () => {
  it("leave alone what is as it should be", () => {
    expect(correct({})).toEqual(square);
    expect(correct({ 3: 1.3, 14: -2 })).toEqual(Float64Array.from([...square].with(3, 1.3).with(14, -2)));
  });

  it("turn a triangle back, and what hangs on it goes along", () => {
    const over = { 3: 0.4, 4: 0.6 }; // beyond the diagonal
    const positions = correct(over);
    expect(Math.min(...shares(positions))).toBeGreaterThan(data.document.floor);
    for (const axis of [0, 1, 2]) {
      const move = (positions[3 + axis] as number) - ([0.4, 0.6, 0][axis] as number);
      expect(positions[12 + axis]).toBeCloseTo((square[12 + axis] as number) + 0.5 * move, 12);
    }
  });

  it("let a triangle do what is allowed, but never turn over", () => {
    const flat = { 3: 0.52, 4: 0.48 };
    const allowed = none.slice().fill(1, 0, 2);
    expect(correct(flat, allowed)[3]).toBe(0.52);
    const positions = correct({ 3: 0.4, 4: 0.6 }, allowed);
    expect(Math.min(...shares(positions))).toBeGreaterThan(0);
  });

  it("open a line that crosses, either side by half", () => {
    const positions = correct({ 1: 0.5, 7: 0.3, 10: 0.4, 4: -0.6 }); // the upper end 0.2 below the lower one
    expect((positions[7] as number) - (positions[1] as number)).toBeGreaterThanOrEqual(-1e-12);
    const allowed = none.slice().fill(1, 2, 2 + RUNGS);
    const crossed = correct({ 1: 0.5, 7: 0.3, 10: 0.4, 4: -0.6 }, allowed);
    expect((crossed[7] as number) - (crossed[1] as number)).toBeLessThan(0);
  });

  it("push a lid out of its eyeball, as far as it is not allowed to lie there", () => {
    const eyes = { ...sockets, centres: Float32Array.from([0, 1, -0.8, 0, 9, 0]) };
    const still = 0.2; // the lid is so deep at rest
    const deep = (positions: Float64Array) =>
      1 - Math.hypot(0, (positions[10] as number) - 1, (positions[11] as number) + 0.8);
    expect(deep(correct({ 11: -0.1 }, none, eyes))).toBeCloseTo(still, 6);
    const allowed = none.slice();
    allowed[2 + RUNGS] = 0.05;
    expect(deep(correct({ 11: -0.1 }, allowed, eyes))).toBeCloseTo(still + 0.05, 6);
  });
});

describe("areas of triangles", () => {
  it("are all of those at rest where nothing moves, and negative where they fold", () => {
    expect(shares(square)).toEqual([1, 1]);
    const share = (x: number): number => shares(square.with(3, x).with(4, 0.5))[0] as number; // the diagonal at x = 0.5
    expect([share(0.75), share(0.5), share(0.25)]).toEqual([0.25, 0, -0.25]);
  });
});
