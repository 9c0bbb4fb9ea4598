import { describe, expect, it } from "vitest";
import { outermostFirst } from "./hair_geometry";

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
