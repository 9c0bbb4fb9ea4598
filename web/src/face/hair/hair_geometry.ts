/** The mesh, the textures and the material of a hair style. */

import * as THREE from "three";
import type { HairStrands } from "../../link/strands";
import { COVERAGE, material, tellPixel } from "../gpu/renderer";
import type { HeadUniforms } from "../head/head";
import { definesOf, type Features } from "../quality/quality_levels";
import { HAIR_FRAGMENT, HAIR_VERTEX } from "./hair_shaders";
import { drawnStrands } from "./hair_strands";

/** What of a style ribbons are made from. */
export interface RibbonStyle {
  readonly name: string;
  readonly hair: HairStrands;
  /** Metres from the skin at each strand's root, lengths and widths: see `HairBlend`. */
  readonly strands: Float32Array;
}

/**
 * Triangles of a ribbon: thin ones, whose course is drawn round; broad ones where all are drawn; and where few are. They
 * lie in a zigzag: on a software renderer a thin triangle costs by the squares of pixels that it touches, and the two
 * triangles of a piece between two places touch the same.
 */
const TRIANGLES = { round: 15, fine: 15, coarse: 8 };

/** The power by which places of thin ribbons stand nearer to the root, where hair bends out of the skin. */
const BENT = 1.4;

/** Where hair is less full than this down grows before it, in thin ribbons of its own; and how full the shader finds those. */
const [DOWNY, DOWN] = [0.4, -1];

/** How wide each of several ribbons of a strand is, of a single one. */
const THIN = 0.37;

export type StyleUniforms = Record<"strands" | "shape", THREE.IUniform<THREE.DataTexture>> &
  Record<"stations" | "width", THREE.IUniform<number>> & {
    tint: THREE.IUniform<THREE.Color>;
    swing: THREE.IUniform<THREE.Vector3>;
  };

/** What all characters that wear a style share of it on the GPU, by its strands. */
const shapes = new WeakMap<HairStrands, THREE.DataTexture>();
const geometries = new WeakMap<HairStrands, Map<string, THREE.InstancedBufferGeometry>>();

/** The uniforms of a style in this colour; `strands` as `HAIR_VERTEX` reads it, four numbers a place; `swing`: how far it is
 * turned against the head, a rotation vector. */
export function styleUniforms(
  { hair, strands }: RibbonStyle,
  tint: THREE.IUniform<THREE.Color>,
  swing: THREE.IUniform<THREE.Vector3> = { value: new THREE.Vector3() },
): StyleUniforms {
  return {
    strands: { value: strandsTexture({ hair, strands }, hair.anchors.length) },
    shape: { value: shapeOf(hair) },
    stations: { value: hair.stations },
    width: { value: hair.width },
    tint,
    swing,
  };
}

/** A style's first `count` strands as a texture, a line each: what is not drawn is not handed over every frame. */
export function strandsTexture(
  { hair, strands }: Pick<RibbonStyle, "hair" | "strands">,
  count: number,
): THREE.DataTexture {
  return texture(strands.subarray(0, 4 * hair.stations * count), hair.stations, count, THREE.FloatType);
}

function shapeOf(hair: HairStrands): THREE.DataTexture {
  const cached = shapes.get(hair);
  if (cached !== undefined) return cached;
  const count = hair.anchors.length;
  const shape = new Uint8Array(4 * count * hair.stations);
  for (let place = 0; place < count * hair.stations; place++) {
    for (let axis = 0; axis < 3; axis++) shape[4 * place + axis] = (hair.facing[3 * place + axis] as number) + 128;
    shape[4 * place + 3] = hair.light[place] as number;
  }
  const shapeTexture = texture(shape, hair.stations, count, THREE.UnsignedByteType);
  shapes.set(hair, shapeTexture);
  return shapeTexture;
}

function texture(
  data: Float32Array | Uint8Array,
  width: number,
  height: number,
  type: THREE.TextureDataType,
): THREE.DataTexture {
  const dataTexture = new THREE.DataTexture(data as Uint8Array<ArrayBuffer>, width, height, THREE.RGBAFormat, type);
  dataTexture.needsUpdate = true;
  return dataTexture;
}

/** How much wider fewer ribbons are: to the power of 1 they would cover as much as all, but lie on the head like slats. */
const WIDENED = 0.75;

/** Fewer ribbons are wider, so that they cover the head as all of them do. */
export function ribbons(style: RibbonStyle, shared: HeadUniforms, own: StyleUniforms, features: Features): THREE.Mesh {
  const thin = features.ribbons > 1;
  const geometry = geometryOf(style.hair, features);
  const share = drawnStrands(style.hair, features.hair) / style.hair.anchors.length;
  const pixel = { value: 0.001 };
  const look = material(HAIR_VERTEX, HAIR_FRAGMENT, {
    ...shared,
    ...own,
    pixel,
    width: { value: (style.hair.width / 2) * share ** -WIDENED * (thin ? THIN : 1) },
  });
  const shape = { KIN: features.ribbons, ...(features.multisample ? { SOFT: "" } : {}) };
  look.defines = { ...definesOf({ ...features, detail: thin }), ...shape };
  look.side = THREE.DoubleSide;
  if (features.multisample) Object.assign(look, COVERAGE);
  const mesh = new THREE.Mesh(geometry, look);
  mesh.name = style.name;
  mesh.frustumCulled = false;
  mesh.castShadow = true;
  tellPixel(mesh, pixel);
  return mesh;
}

/** The ribbons of a style at a level of quality: the same for all who wear it. */
function geometryOf(hair: HairStrands, features: Features): THREE.InstancedBufferGeometry {
  const styleGeometries = geometries.get(hair) ?? new Map<string, THREE.InstancedBufferGeometry>();
  geometries.set(hair, styleGeometries);
  const key = `${features.ribbons} ${features.hair}`;
  const geometry =
    styleGeometries.get(key) ?? ribbon(hair, courseOf(features), features.ribbons, drawnStrands(hair, features.hair));
  styleGeometries.set(key, geometry);
  return geometry;
}

/** The places along a ribbon (across -1..1, along 0..1) that one triangle lies between each three of. */
function courseOf({ ribbons, hair }: Features): [number, number][] {
  if (ribbons > 1) return zigzag(TRIANGLES.round).map(([across, along]) => [across, along ** BENT]);
  return zigzag(hair < 0.5 ? TRIANGLES.coarse : TRIANGLES.fine);
}

/** From side to side; across at the root and at the tip. */
function zigzag(triangles: number): [number, number][] {
  const along = (place: number): number => Math.min(1, Math.max(0, place - 1) / (triangles - 1));
  return Array.from({ length: triangles + 2 }, (_, place) => [place % 2 === 0 ? -1 : 1, along(place)]);
}

/** The first `count` strands of a style, those that see most of the sky first: what they hide is then not shaded. */
export function outermostFirst({ light, stations }: Pick<HairStrands, "light" | "stations">, count: number): number[] {
  const open = (strand: number): number =>
    light.subarray(strand * stations, (strand + 1) * stations).reduce((sum, sky) => sum + sky, 0);
  const skies = Array.from({ length: count }, (_, strand) => open(strand));
  return [...skies.keys()].sort(
    (strand, other) => (skies[other] as number) - (skies[strand] as number) || strand - other,
  );
}

/** Those of the strands at the edges of a style, beside which down grows. */
export function downBefore({ fullness }: Pick<HairStrands, "fullness">, strands: readonly number[]): number[] {
  return strands.filter((strand) => (fullness[strand] as number) < DOWNY);
}

function ribbon(
  hair: HairStrands,
  course: [number, number][],
  kin: number,
  count: number,
): THREE.InstancedBufferGeometry {
  const geometry = new THREE.InstancedBufferGeometry();
  const grown = outermostFirst(hair, count);
  const down = kin > 1 ? downBefore(hair, grown) : [];
  const strands = [...grown, ...down];
  const roots = strands.map((strand) => hair.anchors[strand] as number);
  const fullness = [...grown.map((strand) => hair.fullness[strand] as number), ...down.map(() => DOWN)];
  geometry.setIndex(course.slice(2).flatMap((_, at) => (at % 2 === 0 ? [at, at + 1, at + 2] : [at + 1, at, at + 2])));
  geometry.setAttribute("place", new THREE.Float32BufferAttribute(course.flat(), 2));
  geometry.setAttribute("source", new THREE.InstancedBufferAttribute(Float32Array.from(roots), 1, false, kin));
  geometry.setAttribute("strandRow", new THREE.InstancedBufferAttribute(Float32Array.from(strands), 1, false, kin));
  geometry.setAttribute("fullness", new THREE.InstancedBufferAttribute(Float32Array.from(fullness), 1, false, kin));
  geometry.instanceCount = kin * strands.length;
  return geometry;
}
