import { describe, expect, it } from "vitest";
import { Camera, FIRST_VIEW } from "../math/camera";
import { needlesOn, picked, seen, spacing, within } from "./needles";
import { patch } from "./skin_patch";

const { positions, triangles, fans, net } = patch();
const skin = { positions, triangles };
const box = { left: 0, top: 0, width: 400, height: 400 };
const camera = (yaw = 0) => new Camera({ ...FIRST_VIEW, yaw }, box, { centre: [0, 0, 0.09], radius: 0.06 });
const needles = needlesOn(net.rows, fans, positions);

describe("picked", () => {
  const headOf = (place: number) => camera().project((needles[place] as (typeof needles)[0]).head);

  it("means the needle under the pointer", () => {
    for (const place of [0, 1, 2, 3, 4]) {
      const [x, y] = headOf(place);
      expect(picked(needles, camera(), skin, [x + 2, y - 1], 11)?.place).toBe(place);
    }
  });

  it("means none where none is in reach, and reaches farther for a finger", () => {
    const [x, y] = headOf(0);
    expect(picked(needles, camera(), skin, [x + 15, y], 11)).toBeUndefined();
    expect(picked(needles, camera(), skin, [x + 15, y], 26)?.place).toBe(0);
  });

  it("does not mean a needle behind the head", () => {
    const behind = camera(Math.PI);
    const [x, y] = behind.project((needles[0] as (typeof needles)[0]).head);
    expect(picked(needles, behind, skin, [x, y], 26)).toBeUndefined();
  });
});

it("does not see a needle behind other skin", () => {
  const veil = Float32Array.from([...positions, -1, -1, 0.15, 1, -1, 0.15, 0, 2, 0.15]);
  const before = { positions: veil, triangles: Uint32Array.from([...triangles, 81, 82, 83]) };
  const needle = needles[0] as (typeof needles)[0];
  expect(seen(needle, camera(), skin)).toBe(true);
  expect(seen(needle, camera(), before)).toBe(false);
});

it("finds the needles in a box of the canvas", () => {
  const [x, y] = camera().project((needles[3] as (typeof needles)[0]).head);
  expect(within(needles, camera(), skin, [x - 5, y - 5, x + 5, y + 5])).toEqual([3]);
  expect(within(needles, camera(), skin, [0, 0, 400, 400]).sort()).toEqual([0, 1, 2, 3, 4]);
});

it("knows how close needles stand", () => {
  const far = spacing([40, 41, 22], positions);
  expect(far[0]).toBeCloseTo(far[1] as number, 9);
  expect(far[2]).toBeGreaterThan(far[0] as number);
});
