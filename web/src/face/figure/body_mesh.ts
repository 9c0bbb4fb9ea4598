/** The body as meshes: its triangles and those of the neck that the suit covers. */

import * as THREE from "three";
import { type Body, type FigureSpace, ROW_BONES } from "../../link/figures";
import { COVERAGE, material, type Uniforms } from "../gpu/renderer";
import { type CurvedTriangles, divideLong, type Longest } from "../skin/curved_triangles";
import { between } from "../skin/skin_parts";
import { BODY_FRAGMENT, BODY_VERTEX, LIMBS, ROLL } from "./body_shaders";
import type { SharedFigures } from "./shared_figures";
import { placeOf } from "./skeleton";

/** Metres above the head's rim to which its triangles are taken, of which the suit ends within. */
const COVERED = ROLL + 0.012;

/** How long edges may be at the roll around the neck, and how much longer a metre away from it. */
const [FINEST, COARSER] = [0.005, 0.9];

/** What the suit takes of the generic face, per row: its position (metres), and how far it lies behind the lips. */
interface FaceRows {
  readonly positions: Float32Array;
  readonly bag: Float32Array;
}

/** The body below a head; `skin`: the triangles of the head's skin, as rows. */
export function bodyParts(
  { space, first, skeleton }: SharedFigures,
  skin: Uint32Array,
  { positions, bag }: FaceRows,
  uniforms: Uniforms,
  multisample: boolean,
): THREE.Mesh[] {
  const places = placesOf(space, first, positions);
  const height = heightOver(space, places);
  const heights = Float32Array.from({ length: places.length / 3 }, (_, row) => height(places.subarray(3 * row)));
  const parts = partsOf(space, heights);
  const covered = (row: number) => (heights[row] as number) < COVERED && bag[row] === 0;
  const triangles = [...space.triangles, ...trianglesOf(skin, covered)];
  const place = (row: number) => places.subarray(3 * row, 3 * row + 3) as unknown as readonly number[];
  const divided = divideLong(Uint32Array.from(triangles), place, longestAbout(height));
  const flat = new THREE.BufferGeometry();
  const rows = Float32Array.from({ length: heights.length }, (_, row) => row);
  flat.setIndex(new THREE.BufferAttribute(divided.flat, 1));
  flat.setAttribute("source", new THREE.BufferAttribute(rows, 1));
  flat.setAttribute("parts", new THREE.BufferAttribute(parts, 4));
  flat.setAttribute("place", new THREE.BufferAttribute(places, 3));
  const look = { uniforms: { ...uniforms, limbs: { value: limbsOf(skeleton, first) } }, multisample };
  const meshes = [meshOf(flat, look, {}), skirtOf(space, flat, look)];
  if (divided.curved.length > 0) meshes.push(meshOf(curvedGeometry(divided, parts, places), look, { CURVED: "" }));
  return meshes;
}

/** How a mesh is drawn; `multisample`: where the suit ends by samples of a pixel. */
interface Drawing {
  readonly uniforms: Uniforms;
  readonly multisample: boolean;
}

function meshOf(
  geometry: THREE.BufferGeometry,
  { uniforms, multisample }: Drawing,
  defines: Record<string, string>,
): THREE.Mesh {
  const look = material(BODY_VERTEX, BODY_FRAGMENT, uniforms);
  if (multisample) Object.assign(look, COVERAGE);
  look.defines = { ...defines, ...(multisample ? { SOFT: "" } : {}) };
  return Object.assign(new THREE.Mesh(geometry, look), { name: "body" });
}

/** The skirt, of which both sides are seen. */
function skirtOf({ skirt }: FigureSpace, flat: THREE.BufferGeometry, look: Drawing): THREE.Mesh {
  const geometry = new THREE.BufferGeometry();
  for (const [name, attribute] of Object.entries(flat.attributes)) geometry.setAttribute(name, attribute);
  geometry.setIndex(new THREE.BufferAttribute(skirt, 1));
  const mesh = meshOf(geometry, look, { SKIRT: "" });
  (mesh.material as THREE.Material).side = THREE.DoubleSide;
  return mesh;
}

/** Where arms and legs of the left bend and end on a body: patterns run along them. */
const limbsOf = (skeleton: SharedFigures["skeleton"], { joints }: Body): THREE.Vector3[] =>
  LIMBS.map((name) => new THREE.Vector3().fromArray(joints, 3 * placeOf(skeleton, `${name}.L`)));

function curvedGeometry(divided: CurvedTriangles, parts: Float32Array, places: Float32Array): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setIndex(new THREE.BufferAttribute(divided.curved, 1));
  geometry.setAttribute("rows", new THREE.BufferAttribute(Float32Array.from(divided.corners), 3));
  geometry.setAttribute("shares", new THREE.BufferAttribute(divided.shares, 3));
  geometry.setAttribute("parts", new THREE.BufferAttribute(between(divided, parts, 4), 4));
  geometry.setAttribute("place", new THREE.BufferAttribute(between(divided, places, 3), 3));
  return geometry;
}

/** Where rows lie on the generic figure, metres. */
function placesOf({ headRows, bodyRows }: FigureSpace, body: Body, face: Float32Array): Float32Array {
  const places = new Float32Array(3 * (headRows + bodyRows));
  places.set(face.subarray(0, 3 * headRows));
  places.set(body.positions, 3 * headRows);
  return places;
}

/** Metres above the plane of the head's rim, which leans forward. */
function heightOver({ edge, rim }: FigureSpace, places: Float32Array): (place: ArrayLike<number>) => number {
  const rows = Array.from(edge.subarray(0, rim));
  const mean = (axis: number): number =>
    rows.reduce((sum, row) => sum + (places[3 * row + axis] as number), 0) / rows.length;
  const [up, ahead] = [mean(1), mean(2)];
  let [rise, run] = [0, 0];
  for (const row of rows) {
    const along = (places[3 * row + 2] as number) - ahead;
    rise += along * ((places[3 * row + 1] as number) - up);
    run += along * along;
  }
  const slope = rise / run;
  return (place) => (place[1] as number) - up - slope * ((place[2] as number) - ahead);
}

/** Per row: how much it is of a hand, of a shoe, its height above the rim, which no row below counts, and of which limb (1 an
 * arm, -1 a leg). */
function partsOf({ bones, rowBones, rowWeights, firstOfSkirt }: FigureSpace, heights: Float32Array): Float32Array {
  const parts = new Float32Array(4 * heights.length);
  const ofArm = bones.map((name) => /^(upperarm|lowerarm|wrist|metacarpal|finger)/.test(name));
  const ofLeg = bones.map((name) => /^(upperleg|lowerleg|foot|toes)/.test(name));
  const ofHand = bones.map((name) => /^(wrist|metacarpal|finger)/.test(name));
  const ofShoe = bones.map((name) => /^(foot|toes)/.test(name));
  heights.forEach((height, row) => {
    let [hand, shoe, limb] = [0, 0, 0];
    for (let at = ROW_BONES * row; at < ROW_BONES * (row + 1); at++) {
      const [bone, weight] = [rowBones[at] as number, (rowWeights[at] as number) / 65535];
      if (ofHand[bone]) hand += weight;
      if (ofShoe[bone]) shoe += weight;
      if (ofArm[bone]) limb += weight;
      if (ofLeg[bone] && row < firstOfSkirt) limb -= weight;
    }
    parts.set([hand, shoe, Math.max(-1, height), limb], 4 * row);
  });
  return parts;
}

/** Triangles of which a corner is covered. */
function trianglesOf(skin: Uint32Array, covered: (row: number) => boolean): number[] {
  const kept: number[] = [];
  for (let at = 0; at < skin.length; at += 3) {
    const corners = Array.from(skin.subarray(at, at + 3));
    if (corners.some(covered)) kept.push(...corners);
  }
  return kept;
}

/** Finest where the suit ends; it grows no faster than the way from there. */
const longestAbout =
  (height: (place: readonly number[]) => number): Longest =>
  (middle) =>
    FINEST + COARSER * Math.abs(height(middle) - ROLL);
