import { describe, expect, it } from "vitest";
import { fans } from "../anatomy/topology";
import { ProcessorBlend } from "./processor_blend";
import type { Eyeballs } from "./sum_pass";

const ROWS = 5;
const triangles = Uint32Array.from([0, 1, 2, 0, 2, 3]);
const masks = Float32Array.from([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.5, 0.5, 0, 0, 0, 1, 0, 0, 0, 1]);
/** Row 4 is the left eyeball; it turns about (0, 0, 1) by a quarter from x to y. */
const eyes: Eyeballs = {
  rows: Int32Array.from([4, 5, 5, 5]),
  centres: Float32Array.from([0, 0, 1, 0, 0, 0]),
  radii: Float32Array.from([1, 1]),
  turns: Float32Array.from([0, 1, 0, -1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1]),
};
const coordinate = (number: number, row: number, axis: number): number =>
  Math.fround(Math.sin(7 * number + 3 * row + axis));

function blended(layers: number): ProcessorBlend {
  const blend = new ProcessorBlend(ROWS, fans([triangles], ROWS), undefined, masks);
  for (let number = 0; number < layers; number++) {
    const texels = new Float32Array(4 * 128).map((_, at) => coordinate(number, at >> 2, at & 3));
    blend.keep(number, texels);
  }
  return blend;
}
const row = (values: Float32Array, at: number): number[] => Array.from(values.subarray(4 * at, 4 * at + 3));
const close = (values: number[], expected: number[]): void => {
  values.forEach((value, axis) => {
    expect(value).toBeCloseTo(expected[axis] as number, 6);
  });
};

describe("the blend on the processor", () => {
  it.each([1, 3, 4, 5, 9])("adds up %i layers by weight", (count) => {
    const blend = blended(count);
    const entries = Array.from({ length: count }, (_, layer) => ({ layer, weight: 0.3 - 0.1 * layer }));
    blend.blend({ entries, regional: [], rest: [], lids: [], allowed: undefined }, eyes, {});
    for (let at = 0; at < 4; at++)
      close(
        row(blend.positions, at),
        [0, 1, 2].map((axis) =>
          entries.reduce((sum, { layer, weight }) => sum + weight * coordinate(layer, at, axis), 0),
        ),
      );
  });

  it("passes over what a layer leaves alone, and over layers that are not here, and adds the same", () => {
    const many = 150; // several blocks of rows
    const blend = new ProcessorBlend(many, fans([triangles], many));
    const reach = [many, 40, 3, 0, 100];
    const value = (number: number, at: number, axis: number): number =>
      at < (reach[number] ?? 0) ? coordinate(number, at, axis) : 0;
    reach.forEach((_, number) => {
      blend.keep(
        number,
        new Float32Array(4 * 256).map((_, at) => value(number, at >> 2, at & 3)),
      );
    });
    const entries = [...reach.keys(), 77].map((layer) => ({ layer, weight: 0.4 - 0.1 * layer }));
    blend.blend(
      { entries, regional: [], rest: [], lids: [], allowed: undefined },
      { ...eyes, rows: new Int32Array(4) },
      {},
    );
    for (let at = 0; at < many; at++)
      close(
        row(blend.positions, at),
        [0, 1, 2].map((axis) => entries.reduce((sum, { layer, weight }) => sum + weight * value(layer, at, axis), 0)),
      );
  });

  it("weighs a layer by the regions of each row", () => {
    const blend = blended(2);
    const regional = [{ layer: 1, weights: [0.1, 0.2, 0.4, 0.8] }];
    blend.blend({ entries: [{ layer: 0, weight: 1 }], regional, rest: [], lids: [], allowed: undefined }, eyes, {});
    [0.1, 0.2, 0.6, 0.8].forEach((weight, at) => {
      close(
        row(blend.positions, at),
        [0, 1, 2].map((axis) => coordinate(0, at, axis) + weight * coordinate(1, at, axis)),
      );
    });
  });

  it("turns an eyeball about its centre", () => {
    const blend = blended(1);
    blend.blend({ entries: [{ layer: 0, weight: 1 }], regional: [], rest: [], lids: [], allowed: undefined }, eyes, {});
    const [x, y, z] = [0, 1, 2].map((axis) => coordinate(0, 4, axis)) as [number, number, number];
    close(row(blend.positions, 4), [-y, x, z]);
  });

  it("finds normals by the areas of the triangles around, and forward where there are none", () => {
    const blend = new ProcessorBlend(ROWS, fans([triangles], ROWS));
    const texels = new Float32Array(4 * 128);
    [
      [0, 0, 0],
      [2, 0, 0],
      [2, 2, 0],
      [0, 2, 3],
    ].forEach((place, at) => {
      texels.set(place, 4 * at);
    });
    blend.keep(0, texels);
    blend.blend({ entries: [{ layer: 0, weight: 1 }], regional: [], rest: [], lids: [], allowed: undefined }, eyes, {});
    close(row(blend.normals, 1), [0, 0, 1]);
    const folded = [6, -6, 4].map((value) => value / Math.hypot(6, 6, 4));
    close(row(blend.normals, 3), folded);
    const both = [6, -6, 8].map((value) => value / Math.hypot(6, 6, 8));
    close(row(blend.normals, 0), both);
    expect(row(blend.normals, 4)).toEqual([0, 0, 1]);
  });
});
