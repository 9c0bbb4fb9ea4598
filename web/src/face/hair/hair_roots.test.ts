import { describe, expect, it } from "vitest";
import { arcStyle, BALL } from "./arc_style";
import { mixRoots, rootDensity } from "./hair_roots";
import { MIDDLE } from "./radial_map";

const [X, Y, Z] = MIDDLE.toArray();
/** Rows under a thick tuft on the crown, beside it, and far from it; the last is no skin. */
const positions = Float32Array.from(
  [
    [0, 0],
    [0.012, 0],
    [0.05, 0],
    [0, 0],
  ].flatMap(([x = 0, z = 0]) => [X + x, Y + BALL, Z + z]),
);
const tuft = arcStyle(
  Array.from({ length: 20 }, (_, n) => ({
    root: [0.002 * (n % 5), 1, 0.001 * n],
    toward: [1, 0, 0],
    length: 0.2,
    height: 0.004,
  })),
);

describe("the roots of a style", () => {
  it("shade the skin that they grow out of, less beside them, and no other", () => {
    const density = rootDensity(tuft, positions, 3);
    expect(density[0]).toBeGreaterThan(density[1] as number);
    expect(density[1]).toBeGreaterThan(0);
    expect([density[2], density[3]]).toEqual([0, 0]);
  });

  it("count by how thick hair is", () => {
    const half = { ...tuft, fullness: tuft.fullness.map((_, n) => (n < 10 ? 1 : 0)) };
    const few = rootDensity({ ...tuft, anchors: tuft.anchors.slice(0, 10) }, positions, 3);
    expect(rootDensity(half, positions, 3)).toEqual(few);
  });

  it("of a mix are the mean of its styles by their weights", () => {
    const into = new Float32Array(2);
    mixRoots(
      [
        [Float32Array.from([1, 0]), 0.3],
        [Float32Array.from([0, 1]), 0.1],
      ],
      into,
    );
    expect(into[0]).toBeCloseTo(0.75);
    expect(into[1]).toBeCloseTo(0.25);
    mixRoots([], into);
    expect([...into]).toEqual([0, 0]);
  });
});
