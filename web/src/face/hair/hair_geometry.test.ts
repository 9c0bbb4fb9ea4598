import { describe, expect, it } from "vitest";
import { arcStyle } from "./arc_style";
import { strandsTexture } from "./hair_geometry";

const hair = arcStyle([0, 0.02, 0.04].map((x) => ({ root: [0, 1, x], toward: [0.7, 0, 1], length: 1, height: 0.006 })));
const strands = new Float32Array((4 * hair.points.length) / 3);

describe("the texture of a style's strands", () => {
  it("has a line for each strand that is drawn, and no more", () => {
    for (const count of [1, 2, 3]) {
      const { width, height, data } = strandsTexture({ hair, strands }, count).image;
      expect([width, height]).toEqual([hair.stations, count]);
      expect(data).toHaveLength(4 * hair.stations * count);
    }
  });

  it("reads what is written to the strands afterwards", () => {
    const { data } = strandsTexture({ hair, strands }, 2).image;
    strands[5] = 0.25;
    expect(data?.[5]).toBe(0.25);
  });
});
