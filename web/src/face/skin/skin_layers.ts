/** The painted layers of the skin as textures, and the traits that weigh them. */

import * as THREE from "three";
import { SKIN_LAYERS } from "../../link/constants";
import type { Look } from "../../link/messages";
import type { Uniforms } from "../gpu/renderer";
import { type PictureUniforms, pictureUniforms } from "./picture_mix";

type SkinLayer = (typeof SKIN_LAYERS)[number];

/** What stands for each layer of the skin until its picture is here. */
const BLANKS = {
  mask: [0, 0, 0, 255],
  marks: [0, 0, 0, 128],
  patches: [0, 0, 0, 0],
  relief: [128, 128, 128, 128],
  finish: [115, 51, 255, 128],
  pelt: [0, 0, 0, 0],
  level_folds: [128, 0, 255, 128],
  upright_folds: [128, 0, 255, 128],
} as const satisfies Record<SkinLayer, readonly [number, number, number, number]>;

/** What of a look is a number for the skin's shaders, by the same name. */
export const SKIN_TRAITS = [
  "pores",
  "age",
  "freckles",
  "stubble",
  "brows",
  "makeup",
  "gloss",
  "fur",
  "stripes",
  "lacquer",
  "scalp",
  "milk",
] as const satisfies readonly (keyof Look)[];
type SkinTrait = (typeof SKIN_TRAITS)[number];

/** A look's traits of the skin. */
export type SkinTraits = Record<SkinTrait, number>;

/** What the skin's shaders take: its layers, and the traits and pictures of the faces on air. */
export type SkinUniforms = Uniforms &
  PictureUniforms &
  Record<SkinLayer, THREE.IUniform<THREE.Texture>> &
  Record<SkinTrait, THREE.IUniform<number>>;

/** Uniforms of a skin without layers, or with those of another one. */
export function skinUniforms(layers?: SkinUniforms): SkinUniforms {
  const plain = SKIN_LAYERS.map((name) => [name, layers?.[name] ?? { value: plainTexture(BLANKS[name]) }]);
  return {
    ...Object.fromEntries(plain),
    ...Object.fromEntries(SKIN_TRAITS.map((name) => [name, { value: 0 }])),
    ...pictureUniforms(layers?.picture0.value ?? plainTexture([0, 0, 0, 0])),
  };
}

/** How a level of quality filters the layers: between the levels of a mipmap too, and along a slant from so many samples. */
export interface LayerFilter {
  readonly detail: boolean;
  readonly anisotropy: number;
}

/** Puts the pictures of the layers, in their order, on the skin. */
export function applyLayers(uniforms: SkinUniforms, pictures: readonly ImageBitmap[], filter: LayerFilter): void {
  SKIN_LAYERS.forEach((name, index) => {
    const picture = pictures[index];
    if (picture !== undefined) uniforms[name].value = pictureTexture(picture, filter);
  });
}

/** The mix of looks by their shares: linear in each trait. */
export function mixSkinTraits(shares: readonly (readonly [SkinTraits, number])[]): SkinTraits {
  const sum = (name: SkinTrait): number => shares.reduce((total, [traits, share]) => total + share * traits[name], 0);
  return Object.fromEntries(SKIN_TRAITS.map((name) => [name, sum(name)])) as SkinTraits;
}

function plainTexture(texel: readonly number[]): THREE.Texture {
  const texture = new THREE.DataTexture(Uint8Array.from(texel), 1, 1);
  texture.needsUpdate = true;
  return texture;
}

/** A picture on the skin, its texture coordinates as in glTF: (0, 0) is the upper left corner. */
export function pictureTexture(picture: ImageBitmap, { detail, anisotropy }: LayerFilter): THREE.Texture {
  const texture = new THREE.Texture(picture);
  texture.flipY = false;
  texture.premultiplyAlpha = false;
  texture.generateMipmaps = true;
  texture.minFilter = detail ? THREE.LinearMipmapLinearFilter : THREE.LinearMipmapNearestFilter;
  texture.magFilter = THREE.LinearFilter;
  texture.anisotropy = anisotropy;
  texture.needsUpdate = true;
  return texture;
}
