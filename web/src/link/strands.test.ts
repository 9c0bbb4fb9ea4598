import { describe, expect, it } from "vitest";
import type { HairAsset } from "./messages";
import { readStrands } from "./strands";

const bytes = (array: ArrayBufferView): Uint8Array => new Uint8Array(array.buffer);

/** Two strands of three places, carried by two rows each. */
const asset: HairAsset = {
  stations: 3,
  links: 2,
  width: 0.004,
  scale: 1e-5,
  points: bytes(Int16Array.from([0, 0, 0, 0, 1000, 0, 0, 2000, 0, 100, 0, 0, 100, 1000, 0, 100, 2000, 0])),
  rows: bytes(Uint32Array.from([0, 1, 0, 1, 0, 1, 2, 1, 2, 1, 2, 1])),
  weights: Uint8Array.from([255, 0, 85, 170, 85, 170, 128, 128, 10, 30, 10, 30]),
  anchors: bytes(Uint32Array.from([0, 2])),
  facing: bytes(Int8Array.from(Array.from({ length: 6 }, () => [0, 127, 0]).flat())),
  light: Uint8Array.from([0, 128, 255, 0, 128, 255]),
  fullness: Uint8Array.from([255, 51]),
};

describe("strands", () => {
  it("are read in metres, with weights that sum to one", () => {
    const hair = readStrands(asset, 3);
    expect(hair.points[4]).toBeCloseTo(0.01);
    for (let place = 0; place < 6; place++)
      expect((hair.weights[2 * place] as number) + (hair.weights[2 * place + 1] as number)).toBeCloseTo(1);
    expect([...hair.anchors]).toEqual([0, 2]);
    expect(hair.fullness[1]).toBeCloseTo(0.2);
  });

  it("are refused when they point past the skin or their arrays differ in length", () => {
    expect(() => readStrands(asset, 2)).toThrow("skin's 2 rows");
    expect(() => readStrands({ ...asset, light: new Uint8Array(3) }, 3)).toThrow("2 strands");
    expect(() => readStrands({ ...asset, fullness: new Uint8Array(3) }, 3)).toThrow("2 strands");
  });

  it("are refused with fewer places than they are told about", () => {
    const short = {
      ...asset,
      points: asset.points.slice(0, 24),
      rows: asset.rows.slice(0, 32),
      weights: asset.weights.slice(0, 8),
    };
    const cut = { ...short, stations: 2, facing: asset.facing.slice(0, 12), light: asset.light.slice(0, 4) };
    expect(() => readStrands(cut, 3)).toThrow("2 places");
  });
});
