import { describe, expect, it } from "vitest";
import { HINGES, LIMBS } from "../../link/constants";
import type { LimbField } from "../../link/figures";
import { limbWeights, writeLimbAxes, writeLimbFields } from "./limb_mix";

const field = (driver: string, places: number[], out: number): LimbField => ({
  driver,
  places: Uint32Array.from(places),
  values: Float32Array.from(places.flatMap(() => [out, 0, 0])),
});

const FIELDS = new Map([
  ["bicepsLeft", field("lowerarm01.L", [0, 1], 0.25)],
  ["breath", field("breath", [1], 0.5)],
  ["belly", field("", [2], 1)],
]);
const STRAIGHT = HINGES.map(() => 0);

describe("limb fields of a figure", () => {
  it("shows the larger of what is called and what a bend or breath drives", () => {
    expect([...limbWeights(FIELDS, {}, STRAIGHT, 0)]).toEqual([]);
    expect([...limbWeights(FIELDS, { smile: 1, belly: -0.5 }, [80, 130, 90, 90], 0.25)]).toEqual([
      ["bicepsLeft", 0.5],
      ["breath", 0.25],
      ["belly", -0.5],
    ]);
    expect([...limbWeights(FIELDS, { bicepsLeft: 0.75 }, [80, 0, 0, 0], 0)]).toEqual([["bicepsLeft", 0.75]]);
  });

  it("sums them by their weights, and forgets those of before", () => {
    const sum = new Float32Array(12).fill(9);
    const worn = limbWeights(FIELDS, { belly: 0.5 }, [130, 0, 0, 0], 0.5);
    writeLimbFields(FIELDS, worn, sum);
    expect([...sum]).toEqual([0.25, 0, 0, 0, 0.5, 0, 0, 0, 0.5, 0, 0, 0]);
  });

  it("puts axes between the joints of each limb", () => {
    const names: readonly string[] = [...new Set(LIMBS.flatMap((limb): string[] => limb.slice(0, 2) as string[]))];
    const places = new Map(names.map((name, place) => [name, place]));
    const axes = new Float32Array(9 * LIMBS.length);
    const joints = names.map((_, at) => [0, -at, 0] as const);
    writeLimbAxes({ names, parents: [], places }, joints, axes);
    const [, , outward] = LIMBS[0];
    const way = -names.indexOf(LIMBS[0][1]);
    expect([...axes.subarray(0, 9)].map((number) => number + 0)).toEqual([
      0,
      0,
      0,
      0,
      way,
      0,
      0,
      outward * Math.sign(way),
      0,
    ]);
  });
});
