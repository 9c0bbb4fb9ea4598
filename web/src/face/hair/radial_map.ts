/** How far a head reaches in every direction from the middle of the skull: what keeps hair above the scalp. */

import { Vector3 } from "three";

/** The middle of the generic skull, metres. */
export const MIDDLE = new Vector3(0, 0.03, 0.045);
/** Cells along a side of the map: 7 mm of scalp each. */
const SIZE = 48;
const SAMPLES = 4; // along a triangle's edge

/** Metres from the skull's middle to the skin, in an octahedral map (Engelhardt and Dachsbacher 2008). */
export type RadialMap = Float32Array;

/** The map of a head; meshes: triangles as rows of its positions. */
export function radialMap(positions: Float32Array, meshes: readonly Uint32Array[]): RadialMap {
  const map = new Float32Array(SIZE * SIZE);
  for (const triangles of meshes) splat(map, positions, triangles);
  return filled(map);
}

/** Keeps the farthest of points spread over every triangle. */
function splat(map: RadialMap, positions: Float32Array, triangles: Uint32Array): void {
  const [first, across, down, at] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
  for (let corner = 0; corner < triangles.length; corner += 3) {
    first.fromArray(positions, 3 * (triangles[corner] as number)).sub(MIDDLE);
    across.fromArray(positions, 3 * (triangles[corner + 1] as number)).sub(MIDDLE);
    down.fromArray(positions, 3 * (triangles[corner + 2] as number)).sub(MIDDLE);
    across.sub(first).divideScalar(SAMPLES);
    down.sub(first).divideScalar(SAMPLES);
    for (let a = 0; a <= SAMPLES; a++)
      for (let b = 0; a + b <= SAMPLES; b++) {
        at.copy(first).addScaledVector(across, a).addScaledVector(down, b);
        octahedral(at.x, at.y, at.z);
        const place = Math.round(cell.v) * SIZE + Math.round(cell.u);
        map[place] = Math.max(map[place] as number, at.length());
      }
  }
}

/** Metres from the skull's middle to the skin under a point (bilinear). */
export function radiusUnder(map: RadialMap, x: number, y: number, z: number): number {
  octahedral(x - MIDDLE.x, y - MIDDLE.y, z - MIDDLE.z);
  const left = Math.min(SIZE - 2, Math.floor(cell.u));
  const low = Math.min(SIZE - 2, Math.floor(cell.v));
  const [across, up] = [cell.u - left, cell.v - low];
  const at = low * SIZE + left;
  const below = (map[at] as number) * (1 - across) + (map[at + 1] as number) * across;
  const above = (map[at + SIZE] as number) * (1 - across) + (map[at + SIZE + 1] as number) * across;
  return below * (1 - up) + above * up;
}

/** Metres from the skull's middle to a point. */
export function radiusOf(x: number, y: number, z: number): number {
  const [across, up, ahead] = [x - MIDDLE.x, y - MIDDLE.y, z - MIDDLE.z];
  return Math.sqrt(across * across + up * up + ahead * ahead); // Math.hypot takes ten times as long
}

/** Moves the point at `at` away from the skull's middle, as one at x, y, z whose radius grows by this factor less one. */
export function moveOutward(into: Float32Array, at: number, x: number, y: number, z: number, more: number): void {
  into[at] = (into[at] as number) + more * (x - MIDDLE.x);
  into[at + 1] = (into[at + 1] as number) + more * (y - MIDDLE.y);
  into[at + 2] = (into[at + 2] as number) + more * (z - MIDDLE.z);
}

/** Column and row of the direction that was asked for last, in cells: hair asks for thousands in a frame. */
const cell = { u: 0, v: 0 };

/** Finds a direction's column and row; up is the map's middle. */
function octahedral(x: number, y: number, z: number): void {
  const sum = Math.abs(x) + Math.abs(y) + Math.abs(z) || 1;
  let u = x / sum;
  let v = z / sum;
  if (y < 0) {
    const folded = (1 - Math.abs(v)) * (u < 0 ? -1 : 1);
    v = (1 - Math.abs(u)) * (v < 0 ? -1 : 1);
    u = folded;
  }
  cell.u = (u * 0.5 + 0.5) * (SIZE - 1);
  cell.v = (v * 0.5 + 0.5) * (SIZE - 1);
}

/** The map without holes: what no skin lies behind is as far as what is next to it. */
function filled(map: RadialMap): RadialMap {
  let now = map;
  for (let round = 0; round < SIZE && now.includes(0); round++) {
    const next = now.slice();
    now.forEach((radius, at) => {
      if (radius > 0) return;
      const around = [at - 1, at + 1, at - SIZE, at + SIZE].map((cell) => now[cell] ?? 0).filter((value) => value > 0);
      next[at] = around.length > 0 ? around.reduce((sum, value) => sum + value, 0) / around.length : 0;
    });
    now = next;
  }
  return now;
}
