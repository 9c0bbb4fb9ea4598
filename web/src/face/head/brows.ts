/** Brows as ribbons on the skin. */

import * as THREE from "three";
import type { Mesh } from "../../link/assets";
import { BROW_LINE, BROW_REACH } from "../../link/constants";
import { rowTriangles } from "../anatomy/topology";
import { LAID_OVER, material, tellPixel, type Uniforms } from "../gpu/renderer";
import { BROW_FRAGMENT, BROW_VERTEX } from "./brow_shaders";
import { hashed } from "./lashes";

/** Hairs of one brow, and places along each. */
const [HAIRS, PLACES] = [420, 3];

/** A place on the skin: three rows, and how much of each. */
interface SkinPlace {
  readonly rows: readonly number[];
  readonly shares: readonly number[];
}

/** Where a hair of the character's left brow grows and ends on the generic face seen from ahead (metres), and how strong
 * it is, 0..1: weaker ones show on bushier brows alone. */
export interface BrowHair {
  readonly root: readonly [number, number];
  readonly tip: readonly [number, number];
  readonly strength: number;
  readonly chance: number;
}

/** The brows of a face whose skin has these triangles; undefined where it has none there. `positions`: of the generic face. */
export function brows(meshes: readonly Mesh[], positions: Float32Array, shared: Uniforms): THREE.Mesh | undefined {
  const skin = meshes.find(({ name }) => name === "skin");
  if (skin === undefined) return undefined;
  const find = skinPlaces(rowTriangles(skin), positions);
  const parts = { hair: [], rootRows: [], rootShares: [], tipRows: [], tipShares: [] } as Record<string, number[]>;
  const triangles: number[] = [];
  let first = 0;
  for (const side of [1, -1])
    for (let n = 0; n < HAIRS; n++) {
      const { root, tip, strength, chance } = browHair(n, side);
      const [from, to] = [find(side * root[0], root[1]), find(side * tip[0], tip[1])];
      if (from === undefined || to === undefined) continue;
      for (let vertex = 0; vertex < 2 * PLACES; vertex++) {
        parts.hair?.push((vertex >> 1) / (PLACES - 1), vertex % 2 === 0 ? -1 : 1, strength, chance);
        parts.rootRows?.push(...from.rows);
        parts.rootShares?.push(...from.shares);
        parts.tipRows?.push(...to.rows);
        parts.tipShares?.push(...to.shares);
      }
      for (let at = first; at < first + 2 * PLACES - 2; at += 2)
        triangles.push(at, at + 1, at + 2, at + 1, at + 3, at + 2);
      first += 2 * PLACES;
    }
  if (triangles.length === 0) return undefined;
  const geometry = new THREE.BufferGeometry().setIndex(triangles);
  for (const [name, values] of Object.entries(parts))
    geometry.setAttribute(name, new THREE.Float32BufferAttribute(values, name === "hair" ? 4 : 3));
  return drawn(geometry, shared);
}

function drawn(geometry: THREE.BufferGeometry, shared: Uniforms): THREE.Mesh {
  const pixel = { value: 0.001 };
  const look = material(BROW_VERTEX, BROW_FRAGMENT, { ...shared, pixel });
  Object.assign(look, LAID_OVER, { side: THREE.DoubleSide, depthWrite: false });
  const mesh = new THREE.Mesh(geometry, look);
  mesh.renderOrder = 1;
  tellPixel(mesh, pixel);
  return mesh;
}

/** The `n`th hair of a brow: upright near the nose, lying outwards towards the temple, those of both edges to the middle. */
export function browHair(n: number, side: number): BrowHair {
  const chance = (salt: number): number => hashed(n, (side > 0 ? 40 : 60) + salt);
  const share = (n + chance(1)) / HAIRS;
  const [inner, outer] = BROW_REACH;
  const x = inner + share * (outer - inner);
  const [middle, half] = [lineAt(x, 1), lineAt(x, 2)];
  const height = 1.5 * (2 * chance(2) - 1);
  const strength = (1 - (0.75 * Math.max(0, Math.abs(height) - 0.5)) / 1.2) * (0.65 + 0.35 * chance(3));
  const slope = Math.atan2(lineAt(x + 0.004, 1) - middle, 0.004);
  const lean = ((62 - 58 * share ** 0.6 - 20 * height + 14 * (chance(4) - 0.5)) * Math.PI) / 180;
  const turn = 0.55 * lean + slope;
  const length = (0.0052 + 0.0024 * Math.sin(Math.PI * share)) * (0.7 + 0.5 * chance(5));
  const y = middle + half * height;
  return { root: [x, y], tip: [x + length * Math.cos(turn), y + length * Math.sin(turn)], strength, chance: chance(6) };
}

/** A column of the brow's middle line at `x`. */
function lineAt(x: number, column: 1 | 2): number {
  const after = BROW_LINE.findIndex(([at]) => at >= x);
  const last = BROW_LINE.length - 1;
  const to = BROW_LINE[after < 0 ? last : Math.max(1, after)] as readonly [number, number, number];
  const from = BROW_LINE[(after < 0 ? last : Math.max(1, after)) - 1] as readonly [number, number, number];
  const part = Math.min(1, Math.max(0, (x - from[0]) / (to[0] - from[0])));
  return from[column] + part * (to[column] - from[column]);
}

type Corner = readonly [number, number, number];

/** Finds the place on the front of the skin that lies at (x, y), seen from ahead. */
export function skinPlaces(
  triangles: ArrayLike<number>,
  positions: Float32Array,
): (x: number, y: number) => SkinPlace | undefined {
  const at = (row: number): Corner => [
    positions[3 * row] as number,
    positions[3 * row + 1] as number,
    positions[3 * row + 2] as number,
  ];
  const near: { rows: readonly number[]; corners: readonly [Corner, Corner, Corner]; area: number }[] = [];
  for (let corner = 0; corner < triangles.length; corner += 3) {
    const rows = [0, 1, 2].map((n) => triangles[corner + n] as number);
    const [a, b, c] = rows.map(at) as [Corner, Corner, Corner];
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    const ahead = Math.min(a[2], b[2], c[2]) > AHEAD;
    if (area > 0 && ahead && Math.abs(a[1] - LEVEL) < AROUND) near.push({ rows, corners: [a, b, c], area });
  }
  return (x, y) => {
    let found: SkinPlace | undefined;
    let depth = -Infinity;
    for (const { rows, corners, area } of near) {
      const [a, b, c] = corners;
      const second = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area;
      const third = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area;
      const shares = [1 - second - third, second, third] as const;
      const z = shares[0] * a[2] + second * b[2] + third * c[2];
      if (Math.min(...shares) >= 0 && z > depth) [found, depth] = [{ rows, shares }, z];
    }
    return found;
  };
}

/** Metres on the generic face: brows lie before the first, and so far about the second. */
const [AHEAD, LEVEL, AROUND] = [0.06, 0.02, 0.03];
