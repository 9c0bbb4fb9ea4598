/** What a pointer lands on: the skin, the eyeballs, and the openings closed, so that lips and lids glide over them. */

import type { Anatomy } from "../../../face/anatomy/anatomy";
import { rowTriangles } from "../../../face/anatomy/topology";
import type { Mesh } from "../../../link/assets";
import { add, cross, dot, minus, rowOf, type Triple, times } from "./vectors";

/** Where a ray meets a surface: metres from its origin, the triangle's corners, and the point. */
export interface Hit {
  distance: number;
  corners: Triple;
  point: Triple;
}

/** Where a ray first meets a triangle that faces it (Moller and Trumbore 1997); positions (rows, 3), triangles (t, 3). */
export function hit(
  positions: Float32Array,
  triangles: Uint32Array,
  origin: Readonly<Triple>,
  direction: Readonly<Triple>,
): Hit | undefined {
  const [dx, dy, dz] = direction;
  const [ox, oy, oz] = origin;
  let best = Infinity;
  let nearestHit = -1;
  // Plain numbers, no pairs of them: this runs over ten thousand triangles each time a pointer moves.
  for (let at = 0; at < triangles.length; at += 3) {
    const a = 3 * (triangles[at] as number);
    const b = 3 * (triangles[at + 1] as number);
    const c = 3 * (triangles[at + 2] as number);
    const ax = positions[a] as number;
    const ay = positions[a + 1] as number;
    const az = positions[a + 2] as number;
    const ex = (positions[b] as number) - ax;
    const ey = (positions[b + 1] as number) - ay;
    const ez = (positions[b + 2] as number) - az;
    const fx = (positions[c] as number) - ax;
    const fy = (positions[c + 1] as number) - ay;
    const fz = (positions[c + 2] as number) - az;
    const px = dy * fz - dz * fy;
    const py = dz * fx - dx * fz;
    const pz = dx * fy - dy * fx;
    const volume = ex * px + ey * py + ez * pz;
    if (volume <= 1e-14) continue; // seen from behind
    const sx = ox - ax;
    const sy = oy - ay;
    const sz = oz - az;
    const u = (sx * px + sy * py + sz * pz) / volume;
    if (u < 0 || u > 1) continue;
    const qx = sy * ez - sz * ey;
    const qy = sz * ex - sx * ez;
    const qz = sx * ey - sy * ex;
    const v = (dx * qx + dy * qy + dz * qz) / volume;
    if (v < 0 || u + v > 1) continue;
    const distance = (fx * qx + fy * qy + fz * qz) / volume;
    if (distance <= 0 || distance >= best) continue;
    best = distance;
    nearestHit = at;
  }
  if (nearestHit < 0) return undefined;
  const corners: Triple = [triangles[nearestHit], triangles[nearestHit + 1], triangles[nearestHit + 2]] as Triple;
  return { distance: best, corners, point: add(origin, times(direction, best)) };
}

/** A closed line of rows filled with triangles that face like `outward`: ears cut off at the shortest diagonals. */
export function filled(loop: ArrayLike<number>, positions: Float32Array, outward: Readonly<Triple>): number[] {
  const left = Array.from(loop);
  const triangles: number[] = [];
  const gap = (a: number, b: number) => {
    const between = minus(rowOf(positions, a), rowOf(positions, b));
    return dot(between, between);
  };
  while (left.length >= 3) {
    const count = left.length;
    let [ear, least] = [0, Infinity];
    for (let n = 0; n < count; n++) {
      const across = gap(left[n] as number, left[(n + 2) % count] as number);
      if (across < least) [ear, least] = [n, across];
    }
    const corners = [left[ear], left[(ear + 1) % count], left[(ear + 2) % count]] as Triple;
    triangles.push(...facing(corners, positions, outward));
    left.splice((ear + 1) % count, 1);
  }
  return triangles;
}

function facing(corners: Triple, positions: Float32Array, outward: Readonly<Triple>): Triple {
  const [a, b, c] = corners.map((row) => rowOf(positions, row)) as [Triple, Triple, Triple];
  const front = dot(cross(minus(b, a), minus(c, a)), outward) >= 0;
  return front ? corners : [corners[0], corners[2], corners[1]];
}

/** The vertex of a hit's triangle that lies nearest to it among those that are welcome. */
export function nearestCorner(
  { corners, point }: Hit,
  positions: Float32Array,
  welcome: (row: number) => boolean,
): number | undefined {
  const far = (row: number) => {
    const off = minus(rowOf(positions, row), point);
    return dot(off, off);
  };
  return corners.filter(welcome).sort((a, b) => far(a) - far(b))[0];
}

/** The rows of what hides needles, and of what a pointer lands on: skin, eyeballs, and the lips' opening closed. */
export function surfaceOf(meshes: readonly Mesh[], anatomy: Anatomy): { skin: Uint32Array; land: Uint32Array } {
  const skin = meshes.filter(({ name }) => name === "skin").flatMap((mesh) => [...rowTriangles(mesh)]);
  const balls = meshes.filter(({ name }) => name.startsWith("eye_")).flatMap((mesh) => [...rowTriangles(mesh)]);
  const lips = anatomy.lines.get("lips");
  const closed = lips === undefined ? [] : filled(lips, anatomy.positions, [0, 0, 1]);
  return { skin: Uint32Array.from(skin), land: Uint32Array.from([...skin, ...balls, ...closed]) };
}
