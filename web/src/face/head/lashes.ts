/** Lashes as ribbons along the lids' edges. */

import * as THREE from "three";
import type { Anatomy } from "../anatomy/anatomy";
import { ballFrame } from "../anatomy/eye_mesh";
import { EDGE_POINTS, opening } from "../anatomy/openings";
import { LAID_OVER, material, tellPixel, type Uniforms } from "../gpu/renderer";
import { LASH_FRAGMENT, LASH_VERTEX } from "./lash_shaders";

/** How lashes grow on a lid: how many, in clumps of how many, how long at most (metres on an eye of 15 mm). */
interface Growth {
  count: number;
  clump: number;
  length: number;
}

const UPPER: Growth = { count: 88, clump: 4, length: 0.0068 };
const LOWER: Growth = { count: 40, clump: 3, length: 0.003 };
/** Places along a lash, near and far from what the machine can do. */
const [FINE, COARSE] = [5, 3];

/** The ribbons of all lashes: what `LASH_VERTEX` reads. */
interface Ribbons {
  strands: Float32Array; // (n, 4)
  bends: Float32Array; // (n, 4)
  triangles: Uint32Array;
}

/** Lashes on both lids of both eyes; undefined in a cast that names no lids. */
export function lashes(anatomy: Anatomy, shared: Uniforms, fast = false): THREE.Mesh | undefined {
  const lines = [anatomy.lines.get("lid_left"), anatomy.lines.get("lid_right")];
  const edges = lines.flatMap((line) => (line === undefined ? [] : [opening([...line], anatomy.positions)]));
  if (edges.length < 2) return undefined;
  const { strands, bends, triangles } = ribbons(UPPER, LOWER, fast ? COARSE : FINE);
  const geometry = new THREE.BufferGeometry();
  geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
  geometry.setAttribute("strand", new THREE.BufferAttribute(strands, 4));
  geometry.setAttribute("bend", new THREE.BufferAttribute(bends, 4));
  const pixel = { value: 0.001 };
  const hair = material(LASH_VERTEX, LASH_FRAGMENT, {
    ...shared,
    pixel,
    edgeRows: { value: Int32Array.from(edges.flatMap(({ upper, lower }) => [...upper, ...lower])) },
    ballRows: { value: Int32Array.from([0, 1].flatMap((side) => ballRows(anatomy, side))) },
  });
  Object.assign(hair, LAID_OVER, { side: THREE.DoubleSide, depthWrite: false });
  const drawn = new THREE.Mesh(geometry, hair);
  drawn.renderOrder = 1;
  tellPixel(drawn, pixel);
  return drawn;
}

/** Two rows of an eyeball that lie opposite each other. */
function ballRows(anatomy: Anatomy, side: number): number[] {
  const [first, end] = [anatomy.eyeRows[2 * side] as number, anatomy.eyeRows[2 * side + 1] as number];
  return ballFrame(anatomy.positions, first, end).rows.slice(0, 2);
}

/** The ribbons of both eyes' lashes: for each edge of an opening its strands, in clumps. */
export function ribbons(upper = UPPER, lower = LOWER, stations = FINE): Ribbons {
  const [strands, bends, triangles]: [number[], number[], number[]] = [[], [], []];
  [upper, lower, upper, lower].forEach((growth, edge) => {
    const isUpper = edge % 2 === 0;
    for (let n = 0; n < growth.count; n++) {
      const chance = hashed(n, edge);
      const share = 0.05 + (0.9 * (n + 0.7 * (hashed(n, edge + 9) - 0.5))) / (growth.count - 1);
      const clump = Math.floor((n + 1.6 * (hashed(n, edge + 3) - 0.5)) / growth.clump);
      const meeting = 0.05 + (0.9 * growth.clump * (clump + 0.2 + 0.6 * hashed(clump, edge + 13))) / growth.count;
      const outer = edge < 2 ? share : 1 - share; // + is the character's left: outer on its left eye
      const length =
        growth.length *
        (0.45 + 0.55 * Math.sin(Math.PI * (0.12 + 0.72 * outer)) ** 0.7) *
        (0.75 + 0.25 * hashed(clump, edge + 17)) *
        (0.55 + 0.45 * hashed(n, edge + 5));
      const start = strands.length / 4;
      for (let station = 0; station < stations; station++)
        for (const side of [-1, 1]) {
          strands.push(share, station / (stations - 1), side, chance);
          bends.push(edge * EDGE_POINTS, meeting, length, isUpper ? 1 : -1);
        }
      for (let station = 0; station < stations - 1; station++) {
        const at = start + 2 * station;
        triangles.push(at, at + 1, at + 2, at + 1, at + 3, at + 2);
      }
    }
  });
  return { strands: new Float32Array(strands), bends: new Float32Array(bends), triangles: new Uint32Array(triangles) };
}

/** A number in [0, 1) that two whole numbers decide. */
export function hashed(a: number, b: number): number {
  const mixed = Math.imul(a + 1, 0x9e3779b1) ^ Math.imul(b + 1, 0x85ebca6b);
  return (Math.imul(mixed ^ (mixed >>> 15), 0x2c1b3c6d) >>> 0) / 2 ** 32;
}
