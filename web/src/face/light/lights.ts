/** The lights of a stage, and their mix. */

import { FIRST_LIGHT, type LIGHT_NAMES } from "../../link/constants";
import { decodeSrgb, type Triple } from "./tone";

/** Light from one direction: where it comes from (a unit vector) and how much of each colour. */
export interface Lamp {
  from: Triple;
  light: Triple;
}

/** The light of a stage, in linear light where nothing else is said. */
export interface Light {
  key: Lamp;
  fill: Lamp;
  /** Light along the edges, from behind on either side. */
  rims: { left: Triple; right: Triple; light: Triple };
  /** What comes from above and from below, from everywhere. */
  sky: Triple;
  ground: Triple;
  /** The key's apparent radius in radians: how soft its shadows are. */
  size: number;
  /** How much shadows and hollows count: 1 as they are, 0 not at all. */
  shade: number;
  /** What all light is multiplied with before the tone curve. */
  exposure: number;
  /** The stage behind the head: at the edge of the picture and around the head. */
  backdrop: { edge: Triple; glow: Triple };
}

/** Weights of lights by name; they sum to one. */
export type LightMix = Readonly<Record<string, number>>;

const from = (x: number, y: number, z: number): Triple => unit([x, y, z]);

/** The lights that a show can call. */
export const LIGHTS: Readonly<Record<string, Light>> = {
  // A hard warm lamp from above left, strong light from behind, a dark house.
  theatre: {
    key: { from: from(-0.64, 0.68, 0.64), light: [2.05, 1.74, 1.46] },
    fill: { from: from(0.85, 0, 0.5), light: [0.16, 0.17, 0.22] },
    rims: { left: from(-0.9, 0.25, -0.45), right: from(0.9, 0.35, -0.5), light: [1.0, 1.08, 1.3] },
    sky: [0.085, 0.082, 0.095],
    ground: [0.055, 0.04, 0.037],
    size: 0.12,
    shade: 1,
    exposure: 1,
    backdrop: { edge: [0.0016, 0.0016, 0.002], glow: [0.0105, 0.0094, 0.0118] },
  },
  // A large soft lamp beside the camera, gentle fill, a calm grey wall.
  portrait: {
    key: { from: from(-0.5, 0.48, 0.8), light: [1.38, 1.3, 1.22] },
    fill: { from: from(0.8, 0.1, 0.6), light: [0.32, 0.31, 0.32] },
    rims: { left: from(-0.9, 0.35, -0.45), right: from(0.9, 0.45, -0.5), light: [0.42, 0.44, 0.5] },
    sky: [0.19, 0.19, 0.195],
    ground: [0.12, 0.105, 0.098],
    size: 0.3,
    shade: 1,
    exposure: 1,
    backdrop: { edge: [0.022, 0.024, 0.028], glow: [0.115, 0.118, 0.124] },
  },
  // Nearly the same from everywhere, with just enough from ahead for eyes to shine and a mouth to read, before a green that a keyer takes out.
  flat: {
    key: { from: from(-0.1, 0.3, 0.95), light: [0.55, 0.53, 0.51] },
    fill: { from: from(0.6, 0.1, 0.8), light: [0, 0, 0] },
    rims: { left: from(-0.9, 0.25, -0.45), right: from(0.9, 0.35, -0.5), light: [0, 0, 0] },
    sky: [0.82, 0.8, 0.78],
    ground: [0.8, 0.76, 0.73],
    size: 0.3,
    shade: 0.35,
    exposure: 1,
    backdrop: { edge: decodeSrgb("#00b140"), glow: decodeSrgb("#00b140") },
  },
} satisfies Record<(typeof LIGHT_NAMES)[number], Light>;

/** A light and its share of the mix; the shares sum to one. */
type SharedLight = readonly [light: Light, share: number];

const mixNumber = (shares: readonly SharedLight[], of: (light: Light) => number): number =>
  shares.reduce((sum, [light, share]) => sum + share * of(light), 0);

const mixTriple = (shares: readonly SharedLight[], of: (light: Light) => Triple): Triple => [
  mixNumber(shares, (light) => of(light)[0]),
  mixNumber(shares, (light) => of(light)[1]),
  mixNumber(shares, (light) => of(light)[2]),
];

const mixDirection = (shares: readonly SharedLight[], of: (light: Light) => Triple): Triple =>
  unit(mixTriple(shares, of));

const mixLamp = (shares: readonly SharedLight[], of: (light: Light) => Lamp): Lamp => ({
  from: mixDirection(shares, (light) => of(light).from),
  light: mixTriple(shares, (light) => of(light).light),
});

/** Mixes lights by weight: directions turn towards each other, everything else is linear; unknown names weigh nothing. */
export function mixLights(mix: LightMix): Light {
  const shares = sharesOf(mix);
  if (shares.length === 0) return LIGHTS[FIRST_LIGHT] as Light;
  return {
    key: mixLamp(shares, (light) => light.key),
    fill: mixLamp(shares, (light) => light.fill),
    rims: {
      left: mixDirection(shares, (light) => light.rims.left),
      right: mixDirection(shares, (light) => light.rims.right),
      light: mixTriple(shares, (light) => light.rims.light),
    },
    sky: mixTriple(shares, (light) => light.sky),
    ground: mixTriple(shares, (light) => light.ground),
    size: mixNumber(shares, (light) => light.size),
    shade: mixNumber(shares, (light) => light.shade),
    exposure: mixNumber(shares, (light) => light.exposure),
    backdrop: {
      edge: mixTriple(shares, (light) => light.backdrop.edge),
      glow: mixTriple(shares, (light) => light.backdrop.glow),
    },
  };
}

function sharesOf(mix: LightMix): SharedLight[] {
  const known = Object.entries(mix).flatMap(([name, weight]): SharedLight[] => {
    const light = LIGHTS[name];
    return light === undefined ? [] : [[light, weight]];
  });
  const total = known.reduce((sum, [, weight]) => sum + weight, 0);
  if (!(total > 1e-6)) return [];
  return known.map(([light, weight]) => [light, weight / total]);
}

/** The vector of length one; straight ahead where there is no direction left. */
export function unit([x, y, z]: Triple): Triple {
  const length = Math.hypot(x, y, z);
  return length > 1e-6 ? [x / length, y / length, z / length] : [0, 0, 1];
}

/** The light before another background, one linear colour. */
export const before = (light: Light, background: Triple): Light => ({
  ...light,
  backdrop: { edge: background, glow: background },
});

/** A light by other axes: where its own x, y and z point (unit vectors); a light that goes with a camera, or as a turned head sees it. */
export function lightAlong(light: Light, axes: readonly [Triple, Triple, Triple]): Light {
  const from = (lamp: Triple): Triple => {
    const along = (axis: 0 | 1 | 2): number =>
      lamp[0] * axes[0][axis] + lamp[1] * axes[1][axis] + lamp[2] * axes[2][axis];
    return [along(0), along(1), along(2)];
  };
  const { key, fill, rims } = light;
  return {
    ...light,
    key: { ...key, from: from(key.from) },
    fill: { ...fill, from: from(fill.from) },
    rims: { ...rims, left: from(rims.left), right: from(rims.right) },
  };
}

/** A light as somebody sees it who is turned to their left by `turn` radians. */
export function lightTurned(light: Light, turn: number): Light {
  const [across, ahead] = [Math.cos(turn), Math.sin(turn)];
  if (turn === 0) return light;
  return lightAlong(light, [
    [across, 0, ahead],
    [0, 1, 0],
    [-ahead, 0, across],
  ]);
}
