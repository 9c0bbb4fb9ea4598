import * as THREE from "three";
import { describe, expect, it } from "vitest";
import type { Mesh } from "../../link/assets";
import { CASTING } from "../light/shadow";
import { skinParts } from "./skin_parts";

/** A triangle on a lobe, one on the cheek, and one of the lower lip, 3 mm a side, and one of 8 mm on the chin, metres. */
const corners = [
  [-0.07, -0.04, 0.05],
  [0.04, -0.04, 0.12],
  [0.002, -0.07, 0.155],
  [0.002, -0.1, 0.146, 0.008],
].flatMap(([x = 0, y = 0, z = 0, side = 0.003]) => [
  [x, y, z],
  [x + side, y, z],
  [x, y + side, z],
]);
const mesh = {
  name: "skin",
  source: Uint32Array.from(corners.keys()),
  triangles: Uint32Array.from(corners.keys()),
  uv: new Float32Array(2 * corners.length),
} as unknown as Mesh;
const rows = {
  lines: new Map([["lips", [6, 7]]]),
  positions: Float32Array.from(corners.flat()),
  traits: new Float32Array(4 * corners.length),
  bag: new Float32Array(corners.length),
  lips: [6, 7, 6, 7],
  spots: new Float32Array(4 * corners.length),
  folding: new Float32Array(corners.length),
};

describe("the skin's parts", () => {
  const parts = (detail: boolean) => skinParts(new THREE.BufferGeometry(), mesh, rows, {}, detail);
  const triangles = (part: THREE.Mesh | undefined) => Array.from(part?.geometry.getIndex()?.array ?? []);

  it("cast no shadow where the lobes of the ears are", () => {
    const [skin] = parts(false);
    expect(triangles(skin)).toEqual(Array.from(corners.keys()));
    const casting = skin?.geometry.userData[CASTING] as THREE.BufferAttribute | undefined;
    expect(Array.from(casting?.array ?? [])).toEqual([3, 4, 5, 6, 7, 8, 9, 10, 11]);
  });

  it("have shorter edges at lips and chin alone, where details are drawn", () => {
    expect(parts(false)).toHaveLength(1);
    const [skin, curved] = parts(true);
    expect(triangles(skin)).toEqual([0, 1, 2, 3, 4, 5]);
    expect(new Set(curved?.geometry.getAttribute("rows").array)).toEqual(new Set([6, 7, 8, 9, 10, 11]));
  });
});
