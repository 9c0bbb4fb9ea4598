/** Strands of fur along the outline of a head, on the skin of whoever has fur. */

import * as THREE from "three";
import type { Mesh } from "../../link/assets";
import type { Anatomy } from "../anatomy/anatomy";
import { LAID_OVER, material, tellPixel, type Uniforms } from "../gpu/renderer";
import { FUR_FRAGMENT, FUR_VERTEX } from "./fur_shaders";
import { hashed } from "./lashes";

/** Square metres of the generic skin for each strand; of its ears, which are large on a dog or a cat; and the most strands of a triangle. */
const [AREA, EAR_AREA, MOST] = [10e-6, 2.2e-6, 40];
/** Metres on the generic head: its ears lie farther aside, and higher. */
const EAR = [0.071, -0.045] as const;

/** The side and the place along of a strand's corners. */
const STRAND = [-1, 0, 1, 0, 0, 1];

/** Metres on the generic head: no fur below, where a collar is. */
const COLLAR = -0.13;

/** Metres around the line between the lips, on the generic head, that are bare: what hangs from there would lie across an open mouth. */
const BARE = 0.009;

/** Where strands of fur grow on a skin, three or four numbers each: rows (the nearest first), how much of each row, and the place on its
 * pictures with how far it turns with the head and a chance. */
export interface FurRoots {
  readonly rootRows: number[];
  readonly rootShares: number[];
  readonly root: number[];
}

/** The fur of a skin; `shared`: the uniforms of its head. It is drawn where the look of who wears it has fur, and costs nothing else. */
export function fur(skin: Mesh, anatomy: Anatomy, shared: Uniforms): THREE.Mesh {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setIndex([0, 1, 2]);
  geometry.setAttribute("strand", new THREE.Float32BufferAttribute(STRAND, 2));
  for (const [name, values] of Object.entries(furRoots(skin, anatomy)))
    geometry.setAttribute(name, new THREE.InstancedBufferAttribute(new Float32Array(values), name === "root" ? 4 : 3));
  return drawn(geometry, shared);
}

/** Strands all over the skin but lips and mouth, above the collar, more where they are many on an animal. */
export function furRoots(skin: Mesh, anatomy: Pick<Anatomy, "positions" | "traits" | "bag" | "lips">): FurRoots {
  const { positions, bag } = anatomy;
  const lips = lipLines(anatomy);
  const roots: FurRoots = { rootRows: [], rootShares: [], root: [] };
  for (let corner = 0; corner < skin.triangles.length; corner += 3) {
    const vertices = [0, 1, 2].map((n) => skin.triangles[corner + n] as number);
    const corners = vertices.map((vertex) => {
      return new THREE.Vector3().fromArray(positions, 3 * (skin.source[vertex] as number));
    });
    const low = Math.min(...corners.map(({ y }) => y));
    if (low < COLLAR || vertices.some((vertex) => (bag[skin.source[vertex] as number] as number) > 0)) continue;
    if (lips.some((line) => corners.some((point) => awayFrom(line, point) < BARE))) continue;
    const isEar = Math.min(...corners.map(({ x }) => Math.abs(x))) > EAR[0] && low > EAR[1];
    const area = new THREE.Triangle(...(corners as Three<THREE.Vector3>)).getArea();
    const count = Math.floor(Math.min(MOST, area / (isEar ? EAR_AREA : AREA)) + hashed(corner, 80));
    for (let n = 0; n < count; n++) grow(skin, anatomy.traits, vertices, roots);
  }
  return roots;
}

/** From corner to corner of the mouth, over the middle of its upper edge and of its lower one. */
function lipLines({ positions, lips }: Pick<Anatomy, "positions" | "lips">): THREE.Line3[] {
  const [right, left, upper, lower] = lips.map((row) => new THREE.Vector3().fromArray(positions, 3 * row));
  return [upper, lower].flatMap((middle) =>
    [right, left].map((corner) => new THREE.Line3(corner as THREE.Vector3, middle as THREE.Vector3)),
  );
}

const awayFrom = (line: THREE.Line3, point: THREE.Vector3): number =>
  line.closestPointToPoint(point, true, new THREE.Vector3()).distanceTo(point);

type Three<T> = [T, T, T];

/** Adds a strand somewhere on the triangle of these vertices. */
function grow(skin: Mesh, traits: Float32Array, vertices: readonly number[], { rootRows, rootShares, root }: FurRoots) {
  const strand = root.length / 4;
  const [one, other] = [Math.sqrt(hashed(strand, 81)), hashed(strand, 82)];
  const shares = [1 - one, one * (1 - other), one * other];
  const nearest = [0, 1, 2].sort((a, b) => (shares[b] as number) - (shares[a] as number));
  const mixed = (of: (vertex: number) => number): number =>
    shares.reduce((sum, share, n) => sum + share * of(vertices[n] as number), 0);
  rootRows.push(...nearest.map((n) => skin.source[vertices[n] as number] as number));
  rootShares.push(...nearest.map((n) => shares[n] as number));
  root.push(
    mixed((vertex) => skin.uv[2 * vertex] as number),
    mixed((vertex) => skin.uv[2 * vertex + 1] as number),
    mixed((vertex) => traits[4 * (skin.source[vertex] as number)] as number),
    hashed(strand, 83),
  );
}

function drawn(geometry: THREE.InstancedBufferGeometry, shared: Uniforms): THREE.Mesh {
  const count = geometry.getAttribute("root").count;
  const pixel = { value: 0.001 };
  const look = material(FUR_VERTEX, FUR_FRAGMENT, { ...shared, pixel });
  Object.assign(look, LAID_OVER, { side: THREE.DoubleSide, depthWrite: false });
  const mesh = new THREE.Mesh(geometry, look);
  mesh.renderOrder = 1;
  tellPixel(mesh, pixel);
  const tell = mesh.onBeforeRender;
  mesh.onBeforeRender = (renderer, scene, camera, _, own, group) => {
    tell(renderer, scene, camera, geometry, own, group);
    const isFurry = ((own as THREE.RawShaderMaterial).uniforms.fur?.value as number) > 0;
    geometry.instanceCount = isFurry ? count : 0; // all heads share the strands
  };
  return mesh;
}
