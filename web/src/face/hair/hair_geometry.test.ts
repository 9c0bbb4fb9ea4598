import { describe, expect, it } from "vitest";
import { arcStyle } from "./arc_style";
import { downBefore, outermostFirst, strandsTexture } from "./hair_geometry";

describe("the order of drawing", () => {
  const light = Uint8Array.from([10, 20, 200, 255, 90, 80, 255, 255]);

  it("begins with the strands that see most of the sky", () => {
    expect(outermostFirst({ light, stations: 2 }, 4)).toEqual([3, 1, 2, 0]);
  });

  it("holds each of the strands that a level draws once, and no other", () => {
    expect(outermostFirst({ light, stations: 2 }, 2)).toEqual([1, 0]);
  });

  it("leaves equal ones as they were, so that a picture is the same every time", () => {
    expect(outermostFirst({ light: new Uint8Array(6), stations: 2 }, 3)).toEqual([0, 1, 2]);
  });
});

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

it("down grows beside the strands of the edges alone, in the order in which those are drawn", () => {
  const fullness = Float32Array.of(1, 0.2, 0.9, 0.3);
  expect(downBefore({ fullness }, [3, 0, 2, 1])).toEqual([3, 1]);
  expect(downBefore({ fullness }, [0, 2])).toEqual([]);
});
