/** Strands of fur on the skin of whoever has fur. */

import * as THREE from "three";
import type { Mesh } from "../../link/assets";
import type { Anatomy } from "../anatomy/anatomy";
import { LAID_OVER, material, tellPixel, type Uniforms } from "../gpu/renderer";
import { FUR_FRAGMENT, FUR_VERTEX } from "./fur_shaders";
import { hashed } from "./lashes";

/** Square metres of the generic skin for each strand; of its ears, which are large on a dog or a cat; and the most strands of a triangle. */
const [AREA, EAR_AREA, MOST] = [8e-6, 2.2e-6, 40];
/** Metres on the generic head: its ears lie farther aside, and higher. */
const EAR = [0.071, -0.045] as const;

/** Metres on the generic head: fur lies away from here, and down. */
const [MUZZLE, DOWNWARD] = [new THREE.Vector3(0, -0.045, 0.1), new THREE.Vector3(0, -0.25, -0.1)];

/** The side and the place along of a strand's corners. */
const STRAND = [-1, 0, 1, 0, 0, 1];

/** Metres on the generic head: no fur below, where a collar is. */
const COLLAR = -0.13;

/** Metres around the line between the lips, on the generic head, that are bare: what hangs from there would lie across an open mouth. */
const BARE = 0.012;

/** Where strands of fur grow on a skin, by three numbers each: rows (the nearest first), how much of each row, and how much of the places
 * of the rows their way is; by four: the place on its pictures, how far it turns with the head and a chance; by one: how much of the
 * sky it sees. */
export interface FurRoots {
  readonly rootRows: number[];
  readonly rootShares: number[];
  readonly flow: number[];
  readonly root: number[];
  readonly sky: number[];
}

/** The fur of a skin; `shared`: the uniforms of its head. It is drawn where the look of who wears it has fur, and costs nothing else. */
export function fur(skin: Mesh, anatomy: Anatomy, shared: Uniforms): THREE.Mesh {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setIndex([0, 1, 2]);
  geometry.setAttribute("strand", new THREE.Float32BufferAttribute(STRAND, 2));
  const roots = furRoots(skin, anatomy);
  for (const [name, values] of Object.entries(roots))
    geometry.setAttribute(
      name,
      new THREE.InstancedBufferAttribute(new Float32Array(values), values.length / roots.sky.length),
    );
  return drawn(geometry, shared);
}

/** Strands all over the skin but lips and mouth, above the collar, more where they are many on an animal. */
export function furRoots(skin: Mesh, anatomy: Pick<Anatomy, "positions" | "traits" | "bag" | "lips">): FurRoots {
  const { positions, bag } = anatomy;
  const lips = lipLines(anatomy);
  const roots: FurRoots = { rootRows: [], rootShares: [], flow: [], root: [], sky: [] };
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
    for (let n = 0; n < count; n++) grow(skin, anatomy, vertices, roots);
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
function grow(
  skin: Mesh,
  { positions, traits }: Pick<Anatomy, "positions" | "traits">,
  vertices: readonly number[],
  { rootRows, rootShares, flow, root, sky }: FurRoots,
) {
  const strand = sky.length;
  const [one, other] = [Math.sqrt(hashed(strand, 81)), hashed(strand, 82)];
  const shares = [1 - one, one * (1 - other), one * other];
  const nearest = [0, 1, 2].sort((a, b) => (shares[b] as number) - (shares[a] as number));
  const mixed = (of: (vertex: number) => number): number =>
    shares.reduce((sum, share, n) => sum + share * of(vertices[n] as number), 0);
  rootRows.push(...nearest.map((n) => skin.source[vertices[n] as number] as number));
  rootShares.push(...nearest.map((n) => shares[n] as number));
  const corners = vertices.map((vertex) => {
    return new THREE.Vector3().fromArray(positions, 3 * (skin.source[vertex] as number));
  });
  const way = flowAt(corners as Three<THREE.Vector3>, shares as Three<number>);
  flow.push(...nearest.map((n) => way[n] as number));
  root.push(
    mixed((vertex) => skin.uv[2 * vertex] as number),
    mixed((vertex) => skin.uv[2 * vertex + 1] as number),
    mixed((vertex) => traits[4 * (skin.source[vertex] as number)] as number),
    hashed(strand, 83),
  );
  sky.push(mixed((vertex) => traits[4 * (skin.source[vertex] as number) + 1] as number));
}

/** The way that fur lies, as it is painted (tools/baking/skin/marks.py: fur_strands), and as long, as a sum of a triangle's corners. */
function flowAt(corners: Three<THREE.Vector3>, shares: Three<number>): Three<number> {
  const [a, b, c] = corners;
  const here = new THREE.Vector3();
  for (const [n, corner] of corners.entries()) here.addScaledVector(corner, shares[n] as number);
  const away = here.sub(MUZZLE);
  const long = 0.004 + 0.006 * THREE.MathUtils.smoothstep(away.length(), 0.05, 0.11);
  const way = away.normalize().add(DOWNWARD);
  const triangle = new THREE.Triangle(a, b, c);
  way.projectOnPlane(triangle.getNormal(new THREE.Vector3())).setLength(long);
  const at = triangle.getBarycoord(way.add(a), new THREE.Vector3()) ?? new THREE.Vector3(1, 0, 0);
  return [at.x - 1, at.y, at.z];
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
