import { expect, it } from "vitest";
import { freeRow, withoutPlace, withPlaceAt, withRow } from "./net_edits";
import { patch } from "./skin_patch";

const { net, positions } = patch();
const met = {
  distance: 1,
  corners: [40, 41, 49] as [number, number, number],
  point: [0, 0, 0.1] as [number, number, number],
};

it("finds the nearest vertex of the sheet where no point stands", () => {
  expect(freeRow(net, met, positions)).toBe(41); // 40 has a point, 49 is off the sheet
  expect(freeRow(net, { ...met, corners: [40, 49, 50] }, positions)).toBeUndefined();
});

it("adds, removes and moves points without touching the others", () => {
  expect(withRow(net, 7)).toEqual([40, 42, 38, 58, 22, 7]);
  expect(withoutPlace(net, 1)).toEqual([40, 38, 58, 22]);
  expect(withPlaceAt(net, 1, 7)).toEqual([40, 7, 38, 58, 22]);
});
