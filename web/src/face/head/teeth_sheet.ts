/** The surface of a jaw's teeth, gums and palate or floor, made once in the cage of the generic face. */

import { type CagePlace, COLUMNS, type Column, cagePoint } from "./teeth_cage";
import { BEYOND, JAWS, type Jaw, outline, RIBS, type Rib, type Row, type Tooth } from "./tooth_profiles";

/** Places across a front tooth and one further back, -1..1; the last is the next one's first. */
const ACROSS = {
  front: [-1, -0.82, -0.45, 0, 0.45, 0.82],
  back: [-1, -0.6, 0, 0.6],
} as const;

/** Teeth of a half that show most. */
const FRONT_TEETH = 2;

/** Steps along the cage in which its arch is measured. */
const STEPS = 16 * (COLUMNS - 1);

/** Places in a cage and which way the surface faces there, per vertex. */
export interface Shape {
  /** Column, up, inward (`CagePlace`). */
  readonly places: Float32Array;
  /** The normal in steps of the same three, as a covector: the shader carries it to the face. */
  readonly facings: Float32Array;
}

/** A jaw's surface, whatever face wears it. */
export interface Sheet {
  readonly triangles: Uint32Array;
  readonly person: Shape;
  readonly milk: Shape;
  readonly carnivore: Shape;
  /**
   * Per vertex: height (`Rib`), the tooth's running number from the right end, whose fraction is the place across, share of
   * the other side, and the height among milk teeth.
   */
  readonly marks: Float32Array;
}

/** Where a column of the sheet is: its tooth and its place across it (beyond -1 or 1: behind the last); two teeth meet where there are two. */
type Station = readonly { readonly tooth: number; readonly t: number; readonly left: boolean }[];

/** The sheet of a jaw; `columns`, `positions`: its cage on the generic face, metres. */
export function teethSheet(columns: readonly Column[], positions: Float32Array, upper: boolean): Sheet {
  const jaw = upper ? JAWS.upper : JAWS.lower;
  const arch = measureArch(columns, positions);
  const stations = stationsOf(jaw.person.teeth.length);
  const triangles = gridTriangles(stations.length, upper);
  const shape = (row: Row): Shape => {
    const places = Float32Array.from(stations.flatMap((station) => column(station, row, arch)).flat());
    return { places, facings: facingsOf(places, triangles) };
  };
  return {
    triangles,
    person: shape(jaw.person),
    milk: shape(jaw.milk),
    carnivore: shape(jaw.carnivore),
    marks: marksOf(stations, jaw),
  };
}

function stationsOf(half: number): Station[] {
  const teeth = [...Array(half).keys()];
  const order = [...teeth.reverse().map((n) => [n, false] as const), ...teeth.reverse().map((n) => [n, true] as const)];
  const ends = (at: number): Station[number][] => {
    const found = order[at];
    return found === undefined ? [] : [{ tooth: found[0], t: 0, left: found[1] }];
  };
  const stations: Station[] = order.flatMap(([tooth, left], at) =>
    (tooth < FRONT_TEETH ? ACROSS.front : ACROSS.back).map((t) =>
      t > -1 ? [{ tooth, t, left }] : [...ends(at - 1).map((before) => ({ ...before, t: 1 })), { tooth, t, left }],
    ),
  );
  const at = (end: Station, t: number): Station => end.map((place) => ({ ...place, t }));
  const [first, last] = [ends(0), ends(order.length - 1)];
  return [...[...BEYOND].reverse().map((t) => at(first, -t)), ...stations, ...[1, ...BEYOND].map((t) => at(last, t))];
}

/** The places of one column of the sheet, from outer gum to the middle of palate or floor. */
function column(station: Station, row: Row, arch: Arch): CagePlace[] {
  const along = archPlace(station[0] as Station[number], row.teeth);
  const at = arch.columnAt(along);
  const reach = arch.reachAt(at);
  const thick = arch.thickAt(at);
  const outlines = station.map(({ tooth, t }) => outline(row.teeth[tooth] as Tooth, row, t, reach));
  return Array.from({ length: RIBS }, (_, n): CagePlace => {
    const mean = (part: "up" | "inward") =>
      outlines.reduce((sum, ribs) => sum + (ribs[n] as Rib)[part], 0) / outlines.length;
    return [at, mean("up") / reach, mean("inward") / thick];
  });
}

/** Millimetres along the arch from its middle, + to the character's left. */
function archPlace({ tooth, t, left }: Station[number], teeth: readonly Tooth[]): number {
  const widths = teeth.map(({ width }) => width);
  const before = widths.slice(0, tooth).reduce((sum, width) => sum + width, 0);
  const outward = left ? t : -t; // `t` runs from the character's right to its left
  return (left ? 1 : -1) * (before + (0.5 + 0.5 * outward) * (widths[tooth] as number));
}

function marksOf(stations: readonly Station[], { person, milk }: Jaw): Float32Array {
  const half = person.teeth.length;
  return Float32Array.from(
    stations.flatMap((station) => {
      const { tooth, t, left } = station[0] as Station[number];
      const number = (left ? half + tooth : half - 1 - tooth) + 0.5 + 0.5 * Math.min(Math.max(t, -1), 1);
      const [grown, small] = [heightsOf(station, person), heightsOf(station, milk)];
      const across = outline(person.teeth[tooth] as Tooth, person, t, 16).map((rib) => rib.across);
      return across.flatMap((share, n) => [grown[n] as number, number, share, small[n] as number]);
    }),
  );
}

/** The heights of one column of the sheet. */
function heightsOf(station: Station, row: Row): number[] {
  const outlines = station.map(({ tooth, t }) => outline(row.teeth[tooth] as Tooth, row, t, 16));
  return Array.from(
    { length: RIBS },
    (_, n) => outlines.reduce((sum, ribs) => sum + (ribs[n] as Rib).height, 0) / outlines.length,
  );
}

/** How long the arch is to a column, and how high and thick the cage is there. */
interface Arch {
  columnAt(millimetres: number): number;
  reachAt(column: number): number;
  thickAt(column: number): number;
}

function measureArch(columns: readonly Column[], positions: Float32Array): Arch {
  const point = (place: CagePlace) => cagePoint(columns, positions, place);
  const distance = (a: CagePlace, b: CagePlace) => {
    const [p, q] = [point(a), point(b)];
    return 1000 * Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  };
  const step = (COLUMNS - 1) / STEPS;
  const lengths = [0];
  for (let n = 0; n < STEPS; n++)
    lengths.push((lengths[n] as number) + distance([n * step, 0.5, 0], [(n + 1) * step, 0.5, 0]));
  const middle = lengths[STEPS / 2] as number;
  return {
    columnAt: (millimetres) => {
      const wanted = Math.min(Math.max(middle + millimetres, 0), lengths[STEPS] as number);
      const after = Math.max(
        1,
        lengths.findIndex((length) => length >= wanted),
      );
      const [from, to] = [lengths[after - 1] as number, lengths[after] as number];
      return (after - 1 + (wanted - from) / (to - from)) * step;
    },
    reachAt: (column) => distance([column, 0, 0], [column, 1, 0]),
    thickAt: (column) => distance([column, 0.5, 0], [column, 0.5, 1]),
  };
}

/** Triangles of a grid of so many columns, facing outwards on the face. */
function gridTriangles(columns: number, upper: boolean): Uint32Array {
  const triangles: number[] = [];
  for (let column = 0; column + 1 < columns; column++)
    for (let rib = 0; rib + 1 < RIBS; rib++) {
      const [a, b, c, d] = [0, 1, RIBS, RIBS + 1].map((next) => column * RIBS + rib + next) as [
        number,
        number,
        number,
        number,
      ];
      if (upper) triangles.push(a, b, c, b, d, c);
      else triangles.push(a, c, b, b, c, d);
    }
  return Uint32Array.from(triangles);
}

/** Normals in the cage's own steps: cross products of edges in such coordinates are covectors. */
function facingsOf(places: Float32Array, triangles: Uint32Array): Float32Array {
  const out = new Float32Array(places.length);
  const at = (vertex: number, axis: number) => places[3 * vertex + axis] as number;
  for (let corner = 0; corner < triangles.length; corner += 3) {
    const [a, b, c] = triangles.subarray(corner, corner + 3) as unknown as [number, number, number];
    const edge = (to: number, axis: number) => at(to, axis) - at(a, axis);
    for (const axis of [0, 1, 2]) {
      const [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
      const value = edge(b, next) * edge(c, last) - edge(b, last) * edge(c, next);
      for (const vertex of [a, b, c]) out[3 * vertex + axis] = (out[3 * vertex + axis] as number) + value;
    }
  }
  return out;
}
