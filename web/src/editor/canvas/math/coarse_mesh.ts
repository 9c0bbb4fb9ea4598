/** A coarser skin for faces that are shown small: fewer triangles, of which no pixel sees the difference. */

import type { Anatomy } from "../../../face/anatomy/anatomy";
import type { Mesh } from "../../../link/assets";
import { type Pair, rowOf, type Triple } from "./vectors";

/** How coarse it becomes; metres. */
export interface Fineness {
  /** Rows of lines (lids, lips), around which cells are as small as `near`: they open and close. */
  lines: readonly number[];
  around: number;
  near: number;
  cell: number;
  /** How much of the sky each row sees, 0..1; what sees none lies inside: it closes the mouth, in cells of `INSIDE`. */
  sky: (row: number) => number;
}

const DARK = 0.03;
const INSIDE = 0.012;
const ISLAND = 12; // parts of the picture's side: what lies that far apart in it is not merged

/** The skin with what lies together in a cell drawn as one of its rows: the same rows of positions, fewer of them. */
export function coarsened(mesh: Mesh, positions: Float32Array, fineness: Fineness): Mesh {
  const near = nearRows(positions, fineness);
  const cell = (row: number): number => (fineness.sky(row) > DARK ? fineness.cell : INSIDE);
  const shown = clusters(mesh, positions, (row) => (near(row) ? fineness.near : cell(row)));
  const vertexByKey = new Map<string, number>();
  const [source, uv, openness]: [number[], number[], number[]] = [[], [], []];
  const places = Array.from(mesh.source, (row, corner) => {
    const [u, v] = [mesh.uv[2 * corner] as number, mesh.uv[2 * corner + 1] as number];
    const key = [shown(row), Math.floor(u * ISLAND), Math.floor(v * ISLAND)].join();
    const vertex = vertexByKey.get(key);
    if (vertex !== undefined) return vertex;
    source.push(shown(row));
    uv.push(u, v);
    openness.push(mesh.openness[corner] as number);
    vertexByKey.set(key, source.length - 1);
    return source.length - 1;
  });
  const triangles = kept(mesh, places, source);
  return {
    name: mesh.name,
    source: Uint32Array.from(source),
    uv: Float32Array.from(uv),
    triangles,
    openness: Uint8Array.from(openness),
  };
}

/** For each row the one that is drawn for it: rows of a cell are one where edges within the cell join them. So an upper
 * lip that lies on a lower one stays apart from it. */
function clusters(mesh: Mesh, positions: Float32Array, cellAt: (row: number) => number): (row: number) => number {
  const cells = new Map<number, string>();
  for (const row of mesh.source) {
    const cell = cellAt(row);
    cells.set(row, [cell, ...rowOf(positions, row).map((part) => Math.floor(part / cell))].join());
  }
  const parents = new Map<number, number>();
  const root = (row: number): number => {
    const parent = parents.get(row);
    return parent === undefined ? row : root(parent);
  };
  for (let at = 0; at < mesh.triangles.length; at++) {
    const other = at - (at % 3) + ((at + 1) % 3);
    const [a, b] = [at, other].map((corner) => mesh.source[mesh.triangles[corner] as number] as number) as Pair;
    if (cells.get(a) !== cells.get(b)) continue;
    const [low, high] = [Math.min(root(a), root(b)), Math.max(root(a), root(b))];
    if (low !== high) parents.set(high, low);
  }
  return root;
}

function kept(mesh: Mesh, places: readonly number[], source: readonly number[]): Uint32Array {
  const triangles: number[] = [];
  for (let at = 0; at < mesh.triangles.length; at += 3) {
    const corners = [0, 1, 2].map((n) => mesh.triangles[at + n] as number);
    const drawn = corners.map((corner) => places[corner] as number) as Triple;
    const [a, b, c] = drawn.map((place) => source[place]);
    if (a !== b && b !== c && c !== a) triangles.push(...drawn);
  }
  return Uint32Array.from(triangles);
}

/** Whether a row lies near one of the lines. */
function nearRows(positions: Float32Array, { lines: rows, around }: Fineness): (row: number) => boolean {
  const nearByRow = new Map<number, boolean>();
  return (row) => {
    const before = nearByRow.get(row);
    if (before !== undefined) return before;
    const [x, y, z] = rowOf(positions, row);
    const near = rows.some((other) => {
      const [a, b, c] = rowOf(positions, other);
      return Math.hypot(a - x, b - y, c - z) <= around;
    });
    nearByRow.set(row, near);
    return near;
  };
}

/** How coarse a skin is drawn, by the metres that a pixel covers from there on: cells of a few pixels. */
export const FINENESS = [
  { from: 0.0008, around: 0.006, near: 0.0025, cell: 0.006 },
  { from: 0.0015, around: 0.005, near: 0.004, cell: 0.012 },
] as const;

/** The skin as it is drawn where a face is shown smaller and smaller (`FINENESS`). */
export const coarseMeshes = (meshes: readonly Mesh[], { positions, lines, traits }: Anatomy): Mesh[] => {
  const rows = [...lines.values()].flatMap((line) => [...line]);
  const sky = (row: number): number => traits[4 * row + 1] as number;
  const skin = meshes.filter(({ name }) => name === "skin");
  return FINENESS.flatMap((fineness) =>
    skin.map((mesh) => coarsened(mesh, positions, { ...fineness, lines: rows, sky })),
  );
};
