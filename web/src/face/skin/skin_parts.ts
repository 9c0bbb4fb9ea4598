/** The skin as meshes: small triangles as they are, and large ones divided and curved. */

import * as THREE from "three";
import type { Mesh } from "../../link/assets";
import { material, type Uniforms } from "../gpu/renderer";
import { CASTING } from "../light/shadow";
import { type CurvedTriangles, divideLong, LONGEST_EDGE, type Longest } from "./curved_triangles";
import { SKIN_FRAGMENT, SKIN_VERTEX } from "./skin_shaders";

/** What the skin takes of the generic face, per row: its position (metres), its four traits, and how far it lies behind the lips, whose
 * right and left corner, upper and lower middle are named: four rows; its spots of blood (4), and how far it folds. */
interface SkinRows {
  readonly lines: ReadonlyMap<string, ArrayLike<number>>;
  readonly positions: Float32Array;
  readonly traits: Float32Array;
  readonly bag: Float32Array;
  readonly lips: readonly number[];
  readonly spots: Float32Array;
  readonly folding: Float32Array;
}

/**
 * How long edges may be on the lips' line, metres on the generic face; over the red of the lips longer by a share of what
 * they are away (an open mouth shows their border as an outline), beyond it by as much.
 */
const LONGEST_AT_LIPS = 0.0016;
const ON_LIPS = { wide: 0.012, growth: 0.3 } as const;

/** The chin of the generic face, and how long edges may be within so far of it, metres: on a long one they are twice that. */
const CHIN = { middle: [0, -0.098, 0.145], reach: 0.026, longest: 0.006 } as const;

/** Where the lobes of the generic face's ears are, metres: aside, up, ahead. */
const LOBE = [
  [0.064, 0.08],
  [-0.05, -0.03],
  [0.044, 0.07],
] as const;

/** The skin on `geometry` (index and rows of the mesh): its small triangles, then the large ones of crown, nape and neck. */
export function skinParts(
  geometry: THREE.BufferGeometry,
  mesh: Mesh,
  { positions, traits, bag, lips, spots, folding, lines }: SkinRows,
  common: Uniforms,
  detail: boolean,
): THREE.Mesh[] {
  const shared = { ...common, lipRows: { value: new THREE.Vector4().fromArray([...lips]) } };
  const place = (vertex: number) => {
    const row = mesh.source[vertex] as number;
    return Array.from(positions.subarray(3 * row, 3 * row + 3));
  };
  const edge = detail ? Array.from(lines.get("lips") ?? []) : [];
  const longest = longestBeside(edge, positions, LONGEST_EDGE[detail ? "detail" : "plain"]);
  const divided = divideLong(mesh.triangles, place, longest);
  const columns: Columns = {
    uv: [mesh.uv, 2],
    traits: [atRows(mesh, traits, 4), 4],
    behind: [atRows(mesh, bag, 1), 1],
    spots: [atRows(mesh, spots, 4), 4],
    frontal: [atRows(mesh, positions, 3), 3],
    folding: [atRows(mesh, folding, 1), 1],
  };
  geometry.setIndex(new THREE.BufferAttribute(divided.flat, 1));
  for (const [name, [values, width]] of Object.entries(columns))
    geometry.setAttribute(name, new THREE.BufferAttribute(values, width));
  const parts = [casting(geometry, shared)];
  geometry.userData[CASTING] = new THREE.BufferAttribute(withoutLobes(divided.flat, place), 1);
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

/** Triangles without those of the ears' lobes: light goes through them, and what they cast on the neck is a black wedge. */
function withoutLobes(triangles: Uint32Array, place: (vertex: number) => readonly number[]): Uint32Array {
  const lobe = (vertex: number) =>
    place(vertex).every((value, axis) => {
      const [low, high] = LOBE[axis] as readonly [number, number];
      const at = axis === 0 ? Math.abs(value) : value;
      return low < at && at < high;
    });
  return triangles.filter((_, at) => !lobe(triangles[at - (at % 3)] as number));
}

/**
 * How long edges may be: a line of straight edges shows as a polygon where it is the outline of lips or a chin in a
 * close-up. No line, no such picture: all may be `most`. What it may be grows no faster than the way from the line, else
 * slivers would be divided without end.
 */
function longestBeside(line: readonly number[], positions: Float32Array, most: number): Longest {
  return (middle) => {
    if (line.length === 0) return most;
    const off = Math.hypot(...middle.map((value, axis) => value - (CHIN.middle[axis] as number)));
    const atChin = CHIN.longest + Math.max(0, off - CHIN.reach);
    let nearest = ON_LIPS.wide + most;
    for (const row of line) {
      let square = 0;
      for (let axis = 0; axis < 3; axis++)
        square += ((positions[3 * row + axis] as number) - (middle[axis] as number)) ** 2;
      nearest = Math.min(nearest, Math.sqrt(square));
    }
    const within = Math.min(nearest, ON_LIPS.wide);
    return Math.min(most, atChin, LONGEST_AT_LIPS + ON_LIPS.growth * within + nearest - within);
  };
}

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
