/** Studies the generic face of a cast once: neck, hair, open sky, eyeballs, lines of the openings. */

import { MathUtils } from "three";
import type { Library, Mesh } from "../../link/assets";
import { FOLDING_MOST, HAIRLINE } from "../../link/constants";
import { bloodSpots } from "./blood_spots";
import { type CorrectivesData, readCorrectives } from "./correctives_data";
import { bagDepths, bagTurns, lipRows } from "./mouth_bag";
import { type RegionMasks, readRegionMasks } from "./region_masks";
import { distances, type Fans, fans, lowestBorder, rowTriangles, smoothed } from "./topology";

/** What the stage works out once per cast from the generic face: all that is painted or turned by place. */
export interface Anatomy {
  fans: Fans;
  /** Per row: how far it turns with the head (0 at the neck's rim), open sky, hair, and light (0..1 each). */
  traits: Float32Array;
  /** Rows of the neck's rim, in walking order. */
  rim: number[];
  /** First and end row of the left eyeball, then of the right. */
  eyeRows: Int32Array;
  /** The generic face, (rows, 3) metres. */
  positions: Float32Array;
  /** Rows of the lines around the openings, by name, in walking order. */
  lines: ReadonlyMap<string, Uint32Array>;
  /** How far each row lies behind the lips, metres along the lining of the mouth; 0 outside of it. */
  bag: Float32Array;
  /** Rows of the lips' right and left corner, and of the middle of their upper and lower edge. */
  lips: readonly [number, number, number, number];
  /** How much each row belongs to each spot of blood, four numbers a row. */
  spots: Float32Array;
  /** How far expressions press each row together at most; 0 where skin does not fold. */
  folding: Float32Array;
  /** The fans of the triangles that may fold; undefined: nothing folds. */
  foldingFans: Fans | undefined;
  /** How sums are put right, where the cast says so. */
  correctives: CorrectivesData | undefined;
  /** What belongs to which region, where the cast says so. */
  regions: RegionMasks | undefined;
}

/** 0..1 to 0..1 with level ends. */
const smooth = (x: number): number => MathUtils.smoothstep(x, 0, 1);

const NECK = 0.075; // metres along the skin in which the neck comes to turn with the head

const studied = new WeakMap<Library, Promise<Anatomy>>();

/** The anatomy of a library's cast, worked out once. */
export function loadAnatomy(library: Library): Promise<Anatomy> {
  const anatomy = studied.get(library) ?? buildAnatomy(library);
  studied.set(library, anatomy);
  return anatomy;
}

async function buildAnatomy(library: Library): Promise<Anatomy> {
  const positions = await library.positions(firstFace(library));
  const triangles = library.meshes.map(rowTriangles);
  const around = fans(triangles, library.manifest.vertices);
  const skin = library.meshes.findIndex((mesh) => mesh.name === "skin");
  const rim = skin < 0 ? [] : lowestBorder(triangles[skin] as Uint32Array, positions);
  const sky = smoothed(around, openness(library), 1, 1);
  const { lines, manifest } = library;
  const line = lines.get("lips") ?? [];
  const bag = bagDepths(around, positions, line, rim[0] ?? 0, manifest.skin);
  const traits = readTraits(around, positions, rim, bag, manifest.skin, sky);
  const eyes = eyeRows(library.meshes);
  const lips = lipRows(line, positions);
  const folds = foldingOf(library, triangles[skin] ?? new Uint32Array());
  const spots = bloodSpots(positions);
  return {
    fans: around,
    traits,
    rim,
    eyeRows: eyes,
    positions,
    lines,
    bag,
    lips,
    spots,
    ...folds,
    ...readDocuments(library),
  };
}

/** Where skin folds: the rows that the cast says, and the triangles between them. */
function foldingOf({ manifest }: Library, skin: Uint32Array): Pick<Anatomy, "folding" | "foldingFans"> {
  const folding = new Float32Array(manifest.vertices);
  manifest.folding.forEach((most, row) => {
    folding[row] = (most * FOLDING_MOST) / 255;
  });
  const asked = skin.filter((_, corner) => {
    const first = corner - (corner % 3);
    return [0, 1, 2].every((at) => (folding[skin[first + at] as number] as number) > 0);
  });
  return { folding, foldingFans: asked.length === 0 ? undefined : fans([asked], manifest.vertices) };
}

function readDocuments({ manifest }: Library): Pick<Anatomy, "correctives" | "regions"> {
  const { correctives, regions } = manifest;
  return {
    correctives: correctives ? readCorrectives(correctives) : undefined,
    regions: regions ? readRegionMasks(regions, manifest.vertices) : undefined,
  };
}

function firstFace(library: Library): string {
  const names = library.manifest.faces.map((face) => face.name);
  const name = names.includes("generic") ? "generic" : names[0];
  if (name === undefined) throw new Error("The cast has no face; bake it again.");
  return name;
}

function eyeRows(meshes: readonly Mesh[]): Int32Array {
  return Int32Array.from(
    ["eye_left", "eye_right"].flatMap((name) => {
      const source = meshes.find((mesh) => mesh.name === name)?.source;
      return source === undefined || source.length === 0 ? [0, 0] : [Math.min(...source), Math.max(...source) + 1];
    }),
  );
}

/** How much of the sky over each row is open, 0..1: the head's own shadow in light from everywhere. */
function openness(library: Library): Float32Array {
  const sky = new Float32Array(library.manifest.vertices);
  for (const mesh of library.meshes)
    mesh.source.forEach((row, at) => {
      sky[row] = (mesh.openness[at] as number) / 255;
    });
  return sky;
}

function readTraits(
  around: Fans,
  positions: Float32Array,
  rim: readonly number[],
  bag: Float32Array,
  skin: number,
  sky: Float32Array,
): Float32Array {
  const rows = around.starts.length - 1;
  const far = distances(around, positions, rim);
  const outside = smoothed(
    around,
    far.map((distance) => smooth((distance - 0.008) / NECK)),
    1,
    6,
  );
  const turn = bagTurns(positions, bag.subarray(0, skin), outside);
  const traits = new Float32Array(4 * rows);
  for (let row = 0; row < rows; row++) {
    const part = row < skin ? (turn[row] as number) : 1;
    const light = smooth((far[row] as number) / 0.03 + 0.35);
    traits.set([part, sky[row] as number, hairAt(positions, row), row < skin ? light : 1], 4 * row);
  }
  for (const row of rim) traits[4 * row] = 0;
  return traits;
}

/** Short hair: above a line that runs from the forehead over the temples and behind the ears to the nape. */
function hairAt(positions: Float32Array, row: number): number {
  const [x, y, z] = [positions[3 * row] as number, positions[3 * row + 1] as number, positions[3 * row + 2] as number];
  const angle = Math.abs(Math.atan2(x, z - 0.03)); // 0 straight ahead
  const line = HAIRLINE.findIndex(([at]) => at >= angle);
  const [a0, h0] = HAIRLINE[Math.max(0, line - 1)] as readonly [number, number];
  const [a1, h1] = HAIRLINE[Math.max(0, line)] as readonly [number, number];
  const height = a1 > a0 ? h0 + ((h1 - h0) * (angle - a0)) / (a1 - a0) : h0;
  const ear = y < 0.026 ? smooth((Math.abs(x) - 0.0745) / 0.006) : 0;
  return smooth((y - height) / 0.024 + 0.5) * (1 - ear);
}
