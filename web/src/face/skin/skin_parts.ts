/** The skin as meshes: small triangles as they are, and large ones divided and curved. */

import * as THREE from "three";
import type { Mesh } from "../../link/assets";
import { material, type Uniforms } from "../gpu/renderer";
import { type CurvedTriangles, divideLong, LONGEST_EDGE } from "./curved_triangles";
import { SKIN_FRAGMENT, SKIN_VERTEX } from "./skin_shaders";

/** What the skin takes of the generic face, per row: its position (metres), its four traits, and how far it lies behind the lips, whose
 * right and left corner, upper and lower middle are named: four rows; its spots of blood (4), and how far it folds. */
interface SkinRows {
  readonly positions: Float32Array;
  readonly traits: Float32Array;
  readonly bag: Float32Array;
  readonly lips: readonly number[];
  readonly spots: Float32Array;
  readonly folding: Float32Array;
}

/** The skin on `geometry` (index and rows of the mesh): its small triangles, then the large ones of crown, nape and neck. */
export function skinParts(
  geometry: THREE.BufferGeometry,
  mesh: Mesh,
  { positions, traits, bag, lips, spots, folding }: SkinRows,
  common: Uniforms,
): THREE.Mesh[] {
  const shared = { ...common, lipRows: { value: new THREE.Vector4().fromArray([...lips]) } };
  const place = (vertex: number) => {
    const row = mesh.source[vertex] as number;
    return Array.from(positions.subarray(3 * row, 3 * row + 3));
  };
  const divided = divideLong(mesh.triangles, place, LONGEST_EDGE);
  const columns: Columns = {
    uv: [mesh.uv, 2],
    traits: [atRows(mesh, traits, 4), 4],
    behind: [atRows(mesh, bag, 1), 1],
    spots: [atRows(mesh, spots, 4), 4],
    frontal: [atRows(mesh, positions, 3), 3],
  };
  geometry.setIndex(new THREE.BufferAttribute(divided.flat, 1));
  for (const [name, [values, width]] of Object.entries({
    ...columns,
    folding: [atRows(mesh, folding, 1), 1] as Column,
  }))
    geometry.setAttribute(name, new THREE.BufferAttribute(values, width));
  const parts = [casting(geometry, shared)];
  if (divided.curved.length > 0) parts.push(curvedPart(divided, mesh, columns, shared));
  return parts;
}

/** Numbers of a vertex, and how many. */
type Column = readonly [values: Float32Array, width: number];
type Columns = Readonly<Record<string, Column>>;

/** Values of rows at the vertices of a mesh. */
const atRows = ({ source }: Mesh, values: Float32Array, width: number): Float32Array =>
  Float32Array.from({ length: width * source.length }, (_, at) => {
    return values[width * (source[Math.floor(at / width)] as number) + (at % width)] as number;
  });

function curvedPart(divided: CurvedTriangles, mesh: Mesh, columns: Columns, shared: Uniforms): THREE.Mesh {
  const geometry = new THREE.BufferGeometry();
  const rows = Float32Array.from(divided.corners, (vertex) => mesh.source[vertex] as number);
  geometry.setIndex(new THREE.BufferAttribute(divided.curved, 1));
  geometry.setAttribute("rows", new THREE.BufferAttribute(rows, 3));
  geometry.setAttribute("shares", new THREE.BufferAttribute(divided.shares, 3));
  for (const [name, [values, width]] of Object.entries(columns))
    geometry.setAttribute(name, new THREE.BufferAttribute(between(divided, values, width), width));
  const part = casting(geometry, shared);
  (part.material as THREE.RawShaderMaterial).defines = { CURVED: "" };
  return part;
}

/** Values of the mesh's vertices between them; `width` numbers a vertex. */
export function between({ corners, shares }: CurvedTriangles, values: Float32Array, width: number): Float32Array {
  return Float32Array.from({ length: (width * corners.length) / 3 }, (_, at) => {
    const first = 3 * Math.floor(at / width);
    return [0, 1, 2].reduce((sum, corner) => {
      const vertex = corners[first + corner] as number;
      return sum + (shares[first + corner] as number) * (values[width * vertex + (at % width)] as number);
    }, 0);
  });
}

function casting(geometry: THREE.BufferGeometry, shared: Uniforms): THREE.Mesh {
  const mesh = new THREE.Mesh(geometry, material(SKIN_VERTEX, SKIN_FRAGMENT, shared));
  mesh.castShadow = true;
  return mesh;
}
