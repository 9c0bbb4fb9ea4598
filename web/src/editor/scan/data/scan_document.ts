/** A scan as the server shows it, in typed arrays, and the way between its own frame and the face's. */

import { decode } from "@msgpack/msgpack";
import { aligned } from "../../../link/arrays";
import type { LANDMARKS } from "../../../link/constants";
import type { ScanDoubt, ScanFigures, ScanPreview } from "../../../link/editing_messages";
import { add, cross, minus, rowOf, type Triple, times } from "../../canvas/math/vectors";

export type LandmarkName = (typeof LANDMARKS)[number];
/** Points of a scan by name, in the scan's own frame and unit. */
export type LandmarkPoints = Readonly<Partial<Record<LandmarkName, Triple>>>;

/** scale * rotation @ point + shift; the rotation row by row. */
export interface Placement {
  readonly scale: number;
  readonly rotation: readonly number[];
  readonly shift: Triple;
}

/** Vertices (n, 3), triangles (t, 3) of their rows (none of a cloud), normals (n, 3) and colours (n, 3) of 0 to 255. */
export interface ScanSurface {
  readonly positions: Float32Array;
  readonly triangles: Uint32Array;
  readonly normals: Float32Array;
  readonly colours: Uint8Array | null;
}

/** A fitted face: positions (v, 3) of skin and parts, how far each vertex of the skin is from the scan, millimetres. */
export interface FittedFace {
  readonly positions: Float32Array;
  readonly residual: Float32Array;
  readonly figures: ScanFigures;
}

export interface SeenScan {
  readonly token: string;
  readonly file: string;
  readonly unit: string;
  readonly doubts: readonly ScanDoubt[];
  readonly notes: readonly string[];
  readonly given: LandmarkPoints;
  readonly found: LandmarkPoints;
  readonly shut: boolean | null;
  readonly placement: Placement;
  readonly surface: ScanSurface;
  readonly face: FittedFace | null;
  /** What hair is proposed. */
  readonly hair: HairChoice;
}

/** What is drawn: a surface, and a face that may lie in it. */
export type Drawable = Pick<SeenScan, "surface" | "placement" | "found"> & {
  readonly face: Pick<FittedFace, "positions" | "residual"> | null;
  /** The surface is skin alone: eyes and teeth of the face belong to it. */
  readonly bare?: boolean;
};

/** A hair style of the cast, "" for none, and its colour. */
export interface HairChoice {
  readonly style: string;
  readonly colour: string;
}

export function readScan(bytes: Uint8Array): SeenScan {
  const sent = decode(bytes) as ScanPreview;
  const [positions, triangles] = [new Float32Array(aligned(sent.positions)), new Uint32Array(aligned(sent.triangles))];
  const colours = sent.colours.length === positions.length ? sent.colours.slice() : null;
  const [scale, ...rest] = sent.placement as [number, ...number[]];
  return {
    token: sent.token,
    file: sent.file,
    unit: sent.unit,
    doubts: sent.doubts,
    notes: sent.notes,
    given: sent.given as LandmarkPoints,
    found: sent.found as LandmarkPoints,
    shut: sent.shut,
    placement: { scale, rotation: rest.slice(0, 9), shift: rest.slice(9) as Triple },
    surface: { positions, triangles, normals: normalsOf(positions, triangles), colours },
    face: readFace(sent),
    hair: { style: sent.hair_style, colour: sent.hair },
  };
}

function readFace({ face, residual, figures }: ScanPreview): FittedFace | null {
  if (face === null || residual === null || figures === null) return null;
  return {
    positions: new Float32Array(aligned(face)),
    residual: new Float32Array(aligned(residual)),
    figures,
  };
}

/** Where a point of the scan lies at the face, metres. */
export function placed({ scale, rotation, shift }: Placement, point: Readonly<Triple>): Triple {
  const along = (row: number): number =>
    rotation.slice(3 * row, 3 * row + 3).reduce((sum, part, axis) => sum + part * (point[axis] as number), 0);
  return [0, 1, 2].map((row) => scale * along(row) + (shift[row] as number)) as Triple;
}

/** Where a place at the face lies in the scan's own frame. */
export function unplaced({ scale, rotation, shift }: Placement, place: Readonly<Triple>): Triple {
  const off = minus(place, shift);
  const across = (axis: number): number =>
    [0, 1, 2].reduce((sum, row) => sum + (rotation[3 * row + axis] as number) * (off[row] as number), 0);
  return [0, 1, 2].map((axis) => across(axis) / scale) as Triple;
}

/** The unit normals (n, 3) of vertices, weighted by the triangles' areas; of a cloud, none: towards the eye. */
export function normalsOf(positions: Float32Array, triangles: Uint32Array): Float32Array {
  const normals = new Float32Array(positions.length);
  for (let at = 0; at < triangles.length; at += 3) {
    const [a, b, c] = [triangles[at] as number, triangles[at + 1] as number, triangles[at + 2] as number];
    const from = rowOf(positions, a);
    const normal = cross(minus(rowOf(positions, b), from), minus(rowOf(positions, c), from));
    for (const row of [a, b, c])
      for (let axis = 0; axis < 3; axis++)
        normals[3 * row + axis] = (normals[3 * row + axis] as number) + (normal[axis] as number);
  }
  for (let at = 0; at < normals.length; at += 3) {
    const size = Math.hypot(normals[at] as number, normals[at + 1] as number, normals[at + 2] as number);
    for (let axis = 0; axis < 3 && size > 0; axis++) normals[at + axis] = (normals[at + axis] as number) / size;
  }
  return normals;
}

/** A scan that was not fitted, turned by a quarter: "tip": its top comes forward, "roll": to its left. */
export function quarterTurned(scan: SeenScan, way: "tip" | "roll"): SeenScan {
  const { positions, triangles } = scan.surface;
  const middle = centreOf(positions);
  const turn = ([x, y, z]: Readonly<Triple>): Triple => (way === "tip" ? [x, -z, y] : [-y, x, z]);
  const moved = new Float32Array(positions.length);
  for (let row = 0; 3 * row < positions.length; row++)
    moved.set(add(middle, turn(minus(rowOf(positions, row), middle))), 3 * row);
  const { scale, rotation, shift } = scan.placement;
  const columns = [0, 1, 2].map((axis) => turn([0, 1, 2].map((row) => rotation[3 * row + axis] as number) as Triple));
  const turned = [0, 1, 2].flatMap((row) => columns.map((column) => column[row] as number));
  const surface = { ...scan.surface, positions: moved, normals: normalsOf(moved, triangles) };
  return { ...scan, surface, placement: { scale, rotation: turned, shift: add(middle, turn(minus(shift, middle))) } };
}

function centreOf(positions: Float32Array): Triple {
  const [low, high]: [Triple, Triple] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ];
  positions.forEach((part, at) => {
    low[at % 3] = Math.min(low[at % 3] as number, part);
    high[at % 3] = Math.max(high[at % 3] as number, part);
  });
  return times(add(low, high), 0.5);
}
