import { describe, expect, it } from "vitest";
import { ARCH, ARCH_DEPTH } from "../../link/constants";
import { fans } from "../anatomy/topology";
import { spotAt } from "./tongue";

/** A box, 20 mm wide, 10 mm high and 50 mm deep, with a row along the middle of its top and bottom; the tip is in front. */
const across = [-0.01, 0, 0.01, 0.01, 0, -0.01];
const heights = [0, 0, 0, -0.01, -0.01, -0.01];
const rings = 6;
const positions = Float32Array.from(
  Array.from({ length: rings }, (_, ring) => across.flatMap((x, n) => [x, heights[n] as number, -0.01 * ring])).flat(),
);
const triangles = Uint32Array.from(
  Array.from({ length: 6 * (rings - 1) }, (_, at) => {
    const [ring, n] = [Math.floor(at / 6), at % 6];
    const [a, b] = [6 * ring + n, 6 * ring + ((n + 1) % 6)];
    return [a, b, a + 6, b, b + 6, a + 6];
  }).flat(),
);
const anatomy = { fans: fans([triangles], 6 * rings), positions };
const spot = (ring: number, n: number) => spotAt(anatomy, 6 * ring + n, 0);

describe("the spots of a tongue", () => {
  it("say how far behind the tip and aside they are", () => {
    for (let ring = 0; ring < rings; ring++)
      across.forEach((x, n) => {
        const [behind, aside] = spot(ring, n);
        expect(behind).toBeCloseTo((0.01 * ring) / ARCH_DEPTH, 6);
        expect(aside).toBeCloseTo(x / ARCH, 6);
      });
  });

  it("sink in a furrow along the top's middle, and nowhere come out", () => {
    expect(spot(2, 1)[2]).toBeLessThan(-0.001);
    expect(spot(2, 4)[2]).toBeCloseTo(0, 6); // below
    for (let row = 0; row < 6 * rings; row++) expect(spotAt(anatomy, row, 0)[2]).toBeLessThanOrEqual(0);
  });

  it("make the sides thinner, the farther back the more, alike on both", () => {
    for (const n of [0, 2]) expect(spot(4, n)[2]).toBeLessThan(spot(1, n)[2] - 2e-4);
    expect(spot(3, 0)[2]).toBeCloseTo(spot(3, 2)[2], 6);
  });
});
