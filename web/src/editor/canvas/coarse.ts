/** A coarser skin for faces that are shown small: fewer triangles, of which no pixel sees the difference. */

import type { Mesh } from "../../link/assets";
import type { Anatomy } from "../../stage/anatomy";
import { rowOf, type Triple } from "./triples";

/** What stays as fine as it is, and how coarse the rest becomes; metres. */
export interface Fineness {
  /** Rows of lines (lids, lips) around which nothing is merged: they open and close. */
  kept: readonly number[];
  around: number;
  cell: number;
  /** How much of the sky each row sees, 0..1; what sees none lies inside and is left out. */
  sky: (row: number) => number;
}

const DARK = 0.03;
const ISLAND = 12; // parts of the picture's side: what lies that far apart in it is not merged

/** The skin with rows of a cell drawn as one of them: the same rows of positions, fewer of them. */
export function coarsened(mesh: Mesh, positions: Float32Array, fineness: Fineness): Mesh {
  const fine = nearRows(positions, fineness);
  const cells = new Map<string, number>();
  const rowFor = (row: number): number => {
    if (fine(row)) return row;
    const key = rowOf(positions, row)
      .map((part) => Math.floor(part / fineness.cell))
      .join();
    const first = cells.get(key) ?? row;
    cells.set(key, first);
    return first;
  };
  const made = new Map<string, number>();
  const [source, uv]: [number[], number[]] = [[], []];
  const places = Array.from(mesh.source, (row, corner) => {
    const [u, v] = [mesh.uv[2 * corner] as number, mesh.uv[2 * corner + 1] as number];
    const shown = rowFor(row);
    const key =
      shown === row && fine(row) ? `#${corner}` : [shown, Math.floor(u * ISLAND), Math.floor(v * ISLAND)].join();
    const known = made.get(key);
    if (known !== undefined) return known;
    source.push(shown);
    uv.push(u, v);
    made.set(key, source.length - 1);
    return source.length - 1;
  });
  const triangles = kept(mesh, places, source, (row) => fine(row) || fineness.sky(row) > DARK);
  return { name: mesh.name, source: Uint32Array.from(source), uv: Float32Array.from(uv), triangles };
}

function kept(
  mesh: Mesh,
  places: readonly number[],
  source: readonly number[],
  visible: (row: number) => boolean,
): Uint32Array {
  const triangles: number[] = [];
  for (let at = 0; at < mesh.triangles.length; at += 3) {
    const corners = [0, 1, 2].map((n) => mesh.triangles[at + n] as number);
    if (!corners.some((corner) => visible(mesh.source[corner] as number))) continue;
    const drawn = corners.map((corner) => places[corner] as number) as Triple;
    const [a, b, c] = drawn.map((place) => source[place]);
    if (a !== b && b !== c && c !== a) triangles.push(...drawn);
  }
  return Uint32Array.from(triangles);
}

/** Whether a row lies near one of the kept ones. */
function nearRows(positions: Float32Array, { kept: rows, around }: Fineness): (row: number) => boolean {
  const known = new Map<number, boolean>();
  return (row) => {
    const before = known.get(row);
    if (before !== undefined) return before;
    const [x, y, z] = rowOf(positions, row);
    const near = rows.some((other) => {
      const [a, b, c] = rowOf(positions, other);
      return Math.hypot(a - x, b - y, c - z) <= around;
    });
    known.set(row, near);
    return near;
  };
}

/** Metres around lids and lips that stay fine, and of a cell elsewhere: four pixels of the smallest faces. */
const AROUND = 0.005;
const CELL = 0.009;

/** The meshes as they are drawn where a face is shown small. */
export const coarseMeshes = (meshes: readonly Mesh[], { positions, lines, traits }: Anatomy): Mesh[] =>
  meshes.flatMap((mesh) => {
    if (mesh.name !== "skin") return mesh.name === "tongue" ? [] : [mesh];
    const kept = [...lines.values()].flatMap((line) => [...line]);
    const sky = (row: number) => traits[4 * row + 1] as number;
    return [coarsened(mesh, positions, { kept, around: AROUND, cell: CELL, sky })];
  });
