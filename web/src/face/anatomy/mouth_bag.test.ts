import { describe, expect, it } from "vitest";
import { bagDepths, bagTurns } from "./mouth_bag";
import { fans } from "./topology";

/** A tube of rings a centimetre apart, each of so many rows; its third ring is the lips' line. */
const RING = 8;
const RINGS = 6;
const LINE = 2;
const rows = RING * RINGS;
const positions = Float32Array.from({ length: 3 * rows }, (_, at) => {
  const row = Math.floor(at / 3);
  const turn = (2 * Math.PI * (row % RING)) / RING;
  return [0.02 * Math.cos(turn), 0.02 * Math.sin(turn), -0.01 * Math.floor(row / RING)][at % 3] as number;
});
const triangles = Uint32Array.from(
  Array.from({ length: RING * (RINGS - 1) }, (_, at) => {
    const [ring, n] = [Math.floor(at / RING), at % RING];
    const [a, b] = [ring * RING + n, ring * RING + ((n + 1) % RING)];
    return [a, b, a + RING, b, b + RING, a + RING];
  }).flat(),
);
const around = fans([triangles], rows + 1); // and a row of another part
const line = Array.from({ length: RING }, (_, n) => LINE * RING + n);

describe("the lining of the mouth", () => {
  it("begins behind the lips' line and says how far behind it is", () => {
    const depths = bagDepths(around, positions, line, 0, rows);
    depths.forEach((depth, row) => {
      const expected = row < rows ? Math.max(0, 0.01 * (Math.floor(row / RING) - LINE)) : 0;
      expect(depth).toBeCloseTo(expected, 6);
    });
  });

  it("is nothing where a cast names no lips", () => {
    expect(bagDepths(around, positions, [], 0, rows)).toEqual(new Float32Array(rows + 1));
  });
});

describe("the turn of the lining", () => {
  it("is the head's behind the lips and that of the skin around it in the throat", () => {
    // outer skin at four heights, which turns the less the lower it is; lining behind it, ever deeper
    const places = Float32Array.from([0, 1, 2, 3].flatMap((n) => [0, -0.02 * n, 0.08, 0, -0.02 * n, 0.07]).flat());
    const bag = Float32Array.from([0, 0.01, 0, 0.02, 0, 0.06, 0, 0.08]);
    const outside = Float32Array.from([1, 1, 0.8, 1, 0.5, 1, 0.2, 1]);
    const turns = bagTurns(places, bag, outside);
    expect(Array.from(turns)).toEqual(Array.from(Float32Array.from([1, 1, 0.8, 1, 0.5, 0.5, 0.2, 0.2])));
  });
});
