/** The mesh, the textures and the material of a hair style. */

import * as THREE from "three";
import type { HairStrands } from "../../link/strands";
import { COVERAGE, material } from "../gpu/renderer";
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

/** Pieces of a ribbon where its course is drawn round, where all ribbons are drawn, and where few are. */
const PIECES = { round: 14, fine: 11, coarse: 5 };

/** Thin ribbons that follow each strand where hair is drawn in detail, and how wide each is, of the whole. */
const KIN = { count: 4, width: 0.47 };

export type StyleUniforms = Record<"strands" | "shape", THREE.IUniform<THREE.DataTexture>> &
  Record<"stations" | "width", THREE.IUniform<number>> & { tint: THREE.IUniform<THREE.Color> };

/** The uniforms of a style in this colour; `strands` as `HAIR_VERTEX` reads it, four numbers a place. */
export function styleUniforms({ hair, strands }: RibbonStyle, tint: THREE.IUniform<THREE.Color>): StyleUniforms {
  const count = hair.anchors.length;
  const shape = new Uint8Array(4 * count * hair.stations);
  for (let place = 0; place < count * hair.stations; place++) {
    for (let axis = 0; axis < 3; axis++) shape[4 * place + axis] = (hair.facing[3 * place + axis] as number) + 128;
    shape[4 * place + 3] = hair.light[place] as number;
  }
  return {
    strands: { value: texture(strands, hair.stations, count, THREE.FloatType) },
    shape: { value: texture(shape, hair.stations, count, THREE.UnsignedByteType) },
    stations: { value: hair.stations },
    width: { value: hair.width },
    tint,
  };
}

function texture(
  data: Float32Array | Uint8Array,
  width: number,
  height: number,
  type: THREE.TextureDataType,
): THREE.DataTexture {
  const made = new THREE.DataTexture(data as Uint8Array<ArrayBuffer>, width, height, THREE.RGBAFormat, type);
  made.needsUpdate = true;
  return made;
}

/** Fewer ribbons are wider, so that they cover the head as all of them do. */
export function ribbons(style: RibbonStyle, shared: HeadUniforms, own: StyleUniforms, features: Features): THREE.Mesh {
  const kin = features.detail ? KIN.count : 1;
  const geometry = ribbon(style.hair, piecesOf(features), kin);
  const count = drawnStrands(style.hair, features.hair);
  const share = count / style.hair.anchors.length;
  geometry.instanceCount = kin * count;
  const pixel = { value: 0.001 };
  const look = material(HAIR_VERTEX, HAIR_FRAGMENT, {
    ...shared,
    ...own,
    pixel,
    width: { value: (style.hair.width / 2) * share ** -0.6 * (features.detail ? KIN.width : 1) },
  });
  look.defines = { ...definesOf(features), KIN: kin, ...(features.multisample ? { SOFT: "" } : {}) };
  look.side = THREE.DoubleSide;
  Object.assign(look, features.multisample ? COVERAGE : { blending: THREE.NoBlending });
  const mesh = new THREE.Mesh(geometry, look);
  mesh.name = style.name;
  mesh.frustumCulled = false;
  mesh.castShadow = true;
  mesh.onBeforeRender = (renderer, _scene, camera) => {
    const { w: height } = renderer.getCurrentViewport(new THREE.Vector4());
    pixel.value = 2 / ((camera.projectionMatrix.elements[5] as number) * height);
  };
  return mesh;
}

function piecesOf(features: Features): number {
  if (features.detail) return PIECES.round;
  return features.hair < 0.5 ? PIECES.coarse : PIECES.fine;
}

function ribbon(hair: HairStrands, pieces: number, kin: number): THREE.InstancedBufferGeometry {
  const geometry = new THREE.InstancedBufferGeometry();
  const place: number[] = [];
  const index: number[] = [];
  for (let piece = 0; piece <= pieces; piece++) {
    place.push(-1, piece / pieces, 1, piece / pieces);
    const first = 2 * piece;
    if (piece < pieces) index.push(first, first + 1, first + 2, first + 2, first + 1, first + 3);
  }
  geometry.setIndex(index);
  geometry.setAttribute("place", new THREE.Float32BufferAttribute(place, 2));
  geometry.setAttribute("source", new THREE.InstancedBufferAttribute(Float32Array.from(hair.anchors), 1, false, kin));
  return geometry;
}
