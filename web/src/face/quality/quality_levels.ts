/** The levels of quality, and what each draws. */

import { LEVELS } from "../../link/constants";

/** What a view spends on its picture; every feature can be left out, and the face stays the same face. */
export interface Features {
  /** Light for every pixel; false: for every vertex. */
  readonly pixelLight: boolean;
  /** Texels along a side of the shadow map; 0: no cast shadows. */
  readonly shadow: number;
  /** Fine normals, the layers of skin and iris: what shows from near. */
  readonly detail: boolean;
  /** The share of a hair style's strands that is drawn, 0..1. */
  readonly hair: number;
  /** Ribbons for each of those strands: a broad one, or several thin ones. */
  readonly ribbons: number;
  /** Edges drawn from several samples a pixel; false: smoothed afterwards. */
  readonly multisample: boolean;
  /** Samples along a texture that is seen at a slant, 1 or more. */
  readonly anisotropy: number;
  /** Faces are blended by shaders; false: on the processor, where that is what draws. */
  readonly shaderBlend: boolean;
  /** Pixels drawn at most; a larger picture is drawn smaller and stretched. */
  readonly pixels: number;
  /** Heads have bodies. */
  readonly figure: boolean;
}

export type Level = (typeof LEVELS)[number];

const LOWEST: Features = {
  pixelLight: false,
  shadow: 0,
  detail: false,
  hair: 0.35,
  ribbons: 1,
  multisample: false,
  anisotropy: 1,
  shaderBlend: false,
  pixels: 0.5e6,
  figure: false,
};
const LOW: Features = { ...LOWEST, pixelLight: true, hair: 0.6, pixels: 1e6 };
const MEDIUM: Features = {
  ...LOW,
  shadow: 512,
  detail: true,
  hair: 1,
  multisample: true,
  anisotropy: 4,
  shaderBlend: true,
  pixels: 2.1e6,
};
const GOOD: Features = { ...MEDIUM, ribbons: 5 };
const HIGH: Features = { ...GOOD, shadow: 1024, anisotropy: 8, pixels: Infinity };

/** By level, each as the one below but for what it draws more. */
export const FEATURES: Readonly<Record<Level, Features>> = {
  lowest: LOWEST,
  low: LOW,
  medium: MEDIUM,
  good: GOOD,
  high: HIGH,
};

/**
 * What levels leave out on llvmpipe: several samples a pixel double a frame there, and thin ribbons do so again. In this
 * order, for thin ribbons of one sample are rows of dots where hair comes or goes.
 */
const DEAR_IN_SOFTWARE: Partial<Record<Level, Partial<Features>>> = {
  medium: { multisample: false },
  good: { ribbons: 1 },
};

/**
 * What a view draws at a level. llvmpipe filters along a slant with an ellipse of texels, at a third of a whole frame:
 * without a graphics processor the skin's shader takes a finer step of its textures there instead.
 */
export function featuresOf(level: Level, software: boolean): Features {
  return software ? { ...FEATURES[level], anisotropy: 1, ...DEAR_IN_SOFTWARE[level] } : FEATURES[level];
}

/** The features as the shaders' switches: FAST, SHADOW, DETAIL, SHARPEN, FIGURE. */
export function definesOf(features: Features): Record<string, string> {
  return {
    ...(features.pixelLight ? {} : { FAST: "" }),
    ...(features.shadow > 0 ? { SHADOW: "" } : {}),
    ...(features.detail ? { DETAIL: "" } : {}),
    ...(features.detail && features.anisotropy === 1 ? { SHARPEN: "" } : {}),
    ...(features.figure ? { FIGURE: "" } : {}),
  };
}

/** Drawn pixels per pixel of the page, for a picture of `width` x `height` on a display of `ratio` pixels each. */
export function pixelRatio(features: Features, width: number, height: number, ratio: number): number {
  return Math.min(ratio, Math.sqrt(features.pixels / Math.max(1, width * height)));
}

/** Where a machine starts. */
export const firstLevel = (software: boolean): Level => (software ? "lowest" : "good");

/** The quality that the stages draw at: one level, or from the lowest to the highest of theirs; empty: none says. */
export function levelsOf(stages: readonly ({ readonly level: Level } | null)[]): string {
  const used = LEVELS.filter((level) => stages.some((stage) => stage?.level === level));
  const [lowest, highest] = [used[0], used.at(-1)];
  if (lowest === undefined) return "";
  return lowest === highest ? lowest : `${lowest} to ${highest}`;
}
