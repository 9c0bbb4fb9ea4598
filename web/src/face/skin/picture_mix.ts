/** Which pictures of skin a mix of faces shows, and what their faces would be painted like. */

import * as THREE from "three";

/** A picture on the GPU, and how far it has grown in, 0..1. */
export interface ShownPicture {
  readonly texture: THREE.Texture;
  readonly grown: number;
}

/** Pictures that a skin shows at once; the sampler of each is one of the sixteen that every WebGL 2 has. */
export const PICTURES = ["picture0", "picture1", "picture2", "picture3"] as const;

/** Colours and traits of a look that stand on the painted skin alone. */
export const PAINTED_COLOURS = ["skin", "lip", "brow", "blush", "coat"] as const;
export const PAINTED_TRAITS = ["pores", "age", "freckles", "stubble", "brows", "fur", "stripes"] as const;

/** What a look says of the painted skin. */
export type PaintedLook = Record<(typeof PAINTED_COLOURS)[number], THREE.Color> &
  Record<(typeof PAINTED_TRAITS)[number], number>;

/** What the skin's shaders take of pictures. */
export type PictureUniforms = Record<(typeof PICTURES)[number], THREE.IUniform<THREE.Texture>> & {
  pictureWeights: THREE.IUniform<THREE.Vector4>;
  pictured: THREE.IUniform<PaintedLook>;
};

/** A face on air: its weight, its look, and its picture where it has one. */
export interface PictureShare {
  readonly weight: number;
  readonly look: Record<(typeof PAINTED_COLOURS)[number], THREE.Color> & {
    readonly traits: Readonly<Record<(typeof PAINTED_TRAITS)[number], number>>;
  };
  readonly picture: ShownPicture | undefined;
}

/** Uniforms of a skin without pictures; `blank`: what their samplers read until then. */
export function pictureUniforms(blank: THREE.Texture): PictureUniforms {
  const colours = PAINTED_COLOURS.map((name) => [name, new THREE.Color()]);
  const traits = PAINTED_TRAITS.map((name) => [name, 0]);
  return {
    ...(Object.fromEntries(PICTURES.map((name) => [name, { value: blank }])) as Record<
      (typeof PICTURES)[number],
      THREE.IUniform<THREE.Texture>
    >),
    pictureWeights: { value: new THREE.Vector4() },
    pictured: { value: Object.fromEntries([...colours, ...traits]) as PaintedLook },
  };
}

/**
 * Writes the pictures of a mix: their weights as far as they have grown in, and the mean of their faces' looks, which the
 * shader takes off the painted skin as far as pictures cover it. Of more than it has samplers for, those with the
 * greatest weights stand for all.
 */
export function dressPictures(shares: readonly PictureShare[], into: PictureUniforms): void {
  const shown = shares.flatMap(({ weight, look, picture }) =>
    picture === undefined ? [] : [{ weight: weight * picture.grown, look, texture: picture.texture }],
  );
  shown.sort((picture, other) => Math.abs(other.weight) - Math.abs(picture.weight));
  const total = shown.reduce((sum, { weight }) => sum + weight, 0);
  const drawn = shown.slice(0, PICTURES.length);
  const kept = drawn.reduce((sum, { weight }) => sum + weight, 0);
  const scale = Math.abs(kept) > 1e-6 ? total / kept : 0;
  PICTURES.forEach((name, at) => {
    const picture = drawn[at];
    into.pictureWeights.value.setComponent(at, picture === undefined ? 0 : picture.weight * scale);
    if (picture !== undefined) into[name].value = picture.texture;
  });
  if (scale === 0) return;
  const { value } = into.pictured;
  for (const name of PAINTED_COLOURS) {
    const sum = value[name].setRGB(0, 0, 0);
    for (const { weight, look } of drawn) addScaled(sum, look[name], weight / kept);
  }
  for (const name of PAINTED_TRAITS)
    value[name] = drawn.reduce((sum, { weight, look }) => sum + (weight / kept) * look.traits[name], 0);
}

/** Adds a colour times a weight to a sum. */
export function addScaled(sum: THREE.Color, { r, g, b }: THREE.Color, weight: number): void {
  sum.setRGB(sum.r + r * weight, sum.g + g * weight, sum.b + b * weight);
}
