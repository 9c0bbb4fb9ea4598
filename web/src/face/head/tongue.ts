/** The tongue: the cast's own, drawn round, with a furrow and thin sides. */

import * as THREE from "three";
import type { Mesh } from "../../link/assets";
import { ARCH, ARCH_DEPTH } from "../../link/constants";
import type { Anatomy } from "../anatomy/anatomy";
import { normalAt } from "../anatomy/topology";
import { material, type Uniforms } from "../gpu/renderer";
import type { Features } from "../quality/quality_levels";
import { divideLong } from "../skin/curved_triangles";
import { between } from "../skin/skin_parts";
import { TONGUE_FRAGMENT, TONGUE_VERTEX } from "./mouth_shaders";
import { type Cages, COLUMNS } from "./teeth_cage";

/** Edges of the drawn tongue at most, metres on the generic face. */
const LONGEST = 0.01;

/** The furrow's depth and half its width; how much thinner the sides are at the tip, and how much more at the root; metres. */
const FURROW = 0.0014;
const FURROW_WIDTH = 0.0026;
const THINNER = 0.0012;
const THINNER_BEHIND = 0.0026;

/** The tongue on `geometry`, which has its places: small triangles as they are, and long ones divided and curved. */
export function tongueParts(
  geometry: THREE.BufferGeometry,
  mesh: Mesh,
  anatomy: Anatomy,
  cages: Cages,
  uniforms: Uniforms,
  { detail }: Features,
): THREE.Mesh[] {
  const { positions } = anatomy;
  const look = { ...uniforms, ...jawUniforms(mesh, positions, cages) };
  const tip = tipOf(mesh, positions);
  const spots = Float32Array.from([...mesh.source].flatMap((row) => spotAt(anatomy, row, tip)));
  geometry.setAttribute("spot", new THREE.BufferAttribute(spots, 3));
  if (!detail) return [part(geometry, look)];
  const place = (vertex: number) => {
    const row = mesh.source[vertex] as number;
    return Array.from(positions.subarray(3 * row, 3 * row + 3));
  };
  const divided = divideLong(mesh.triangles, place, () => LONGEST);
  const rows = Float32Array.from(divided.corners, (vertex) => mesh.source[vertex] as number);
  const curved = new THREE.BufferGeometry();
  geometry.setIndex(new THREE.BufferAttribute(divided.flat, 1));
  curved.setIndex(new THREE.BufferAttribute(divided.curved, 1));
  curved.setAttribute("rows", new THREE.BufferAttribute(rows, 3));
  curved.setAttribute("shares", new THREE.BufferAttribute(divided.shares, 3));
  curved.setAttribute("spot", new THREE.BufferAttribute(between(divided, spots, 3), 3));
  return [part(geometry, look), part(curved, look, { CURVED: "" })];
}

function part(geometry: THREE.BufferGeometry, uniforms: Uniforms, defines: Record<string, string> = {}): THREE.Mesh {
  const look = material(TONGUE_VERTEX, TONGUE_FRAGMENT, uniforms);
  look.side = THREE.DoubleSide;
  look.defines = defines;
  return new THREE.Mesh(geometry, look);
}

/**
 * Where a row of the tongue lies: how far behind the tip, in depths of the arch, and how far aside of its middle, in
 * radii of it; and how far the drawn surface lies over the cast's there, metres: a furrow along the middle, and sides that
 * leave room for the teeth.
 */
export function spotAt(
  { fans, positions }: Pick<Anatomy, "fans" | "positions">,
  row: number,
  tip: number,
): [number, number, number] {
  const [aside, up] = normalAt(fans, positions, row);
  const x = positions[3 * row] as number;
  const behind = ((positions[3 * tip + 2] as number) - (positions[3 * row + 2] as number)) / ARCH_DEPTH;
  const thin = THINNER + THINNER_BEHIND * Math.min(behind, 1);
  const furrow = FURROW * Math.exp(-((x / FURROW_WIDTH) ** 2)) * Math.max(up, 0);
  return [behind, x / ARCH, -furrow - thin * aside * aside];
}

/** The row of the tongue's tip. */
const tipOf = ({ source }: Mesh, positions: Float32Array): number =>
  source.reduce((tip, row) => ((positions[3 * row + 2] as number) > (positions[3 * tip + 2] as number) ? row : tip));

/** Where the lower jaw is and how its tongue lies in it at rest; two equal ends where the cast has no such teeth. */
function jawUniforms(mesh: Mesh, positions: Float32Array, { upper, lower }: Cages): Uniforms {
  const tip = tipOf(mesh, positions);
  const none = { jaw: { value: new THREE.Vector4() }, tips: { value: new THREE.Vector2() } };
  if (upper === undefined || lower === undefined) return { ...none, tipAtRest: { value: new THREE.Vector2() } };
  const middle = (COLUMNS - 1) / 2;
  const [gum, , edge] = lower[middle] as readonly [number, number, number, number];
  const [right, left] = [(lower[0] as readonly number[])[2], (lower[COLUMNS - 1] as readonly number[])[2]];
  const point = (row: number) => new THREE.Vector3().fromArray(positions, 3 * row);
  const [ends, front] = [[point(right as number), point(left as number)] as const, point(edge)];
  const up = front.clone().sub(point(gum)).normalize();
  const ahead = front.clone().sub(ends[0].clone().add(ends[1]).multiplyScalar(0.5)).normalize();
  const off = point(tip).sub(front).divideScalar(ends[0].distanceTo(ends[1]));
  return {
    jaw: { value: new THREE.Vector4(gum, edge, right, left) },
    tips: { value: new THREE.Vector2((upper[middle] as readonly number[])[2], tip) },
    tipAtRest: { value: new THREE.Vector2(off.dot(up), off.dot(ahead)) },
  };
}
