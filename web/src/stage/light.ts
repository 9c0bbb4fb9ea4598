/** A direction or a colour in linear light. */
export type Triple = readonly [number, number, number];

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

/** The lights that a show can call; the first is the one a show begins with. */
export const LIGHTS: Readonly<Record<string, Light>> = {
  theatre: {
    key: { from: from(-0.68, 0.62, 0.66), light: [1.72, 1.52, 1.34] },
    fill: { from: from(0.85, 0, 0.5), light: [0.25, 0.24, 0.27] },
    rims: { left: from(-0.9, 0.25, -0.45), right: from(0.9, 0.35, -0.5), light: [0.62, 0.7, 0.9] },
    sky: [0.105, 0.1, 0.11],
    ground: [0.07, 0.05, 0.046],
    size: 0.05,
    shade: 1,
    exposure: 1,
    backdrop: { edge: [0.0023, 0.0024, 0.003], glow: [0.0124, 0.0112, 0.0142] },
  },
};

/** The light a show begins with. */
export const FIRST_LIGHT = "theatre";

/** The lights mixed by weight: directions turn towards each other, everything else is linear; unknown names weigh nothing. */
export function mixLights(mix: LightMix): Light {
  const known = Object.entries(mix).flatMap(([name, weight]): [Light, number][] => {
    const light = LIGHTS[name];
    return light === undefined ? [] : [[light, weight]];
  });
  const total = known.reduce((sum, [, weight]) => sum + weight, 0);
  if (!(total > 1e-6)) return LIGHTS[FIRST_LIGHT] as Light;
  const shares = known.map(([light, weight]): [Light, number] => [light, weight / total]);
  const number = (of: (light: Light) => number) => shares.reduce((sum, [light, share]) => sum + share * of(light), 0);
  const triple = (of: (light: Light) => Triple): Triple => [
    number((light) => of(light)[0]),
    number((light) => of(light)[1]),
    number((light) => of(light)[2]),
  ];
  const lamp = (of: (light: Light) => Lamp): Lamp => ({
    from: unit(triple((light) => of(light).from)),
    light: triple((light) => of(light).light),
  });
  return {
    key: lamp((light) => light.key),
    fill: lamp((light) => light.fill),
    rims: {
      left: unit(triple((light) => light.rims.left)),
      right: unit(triple((light) => light.rims.right)),
      light: triple((light) => light.rims.light),
    },
    sky: triple((light) => light.sky),
    ground: triple((light) => light.ground),
    size: number((light) => light.size),
    shade: number((light) => light.shade),
    exposure: number((light) => light.exposure),
    backdrop: { edge: triple((light) => light.backdrop.edge), glow: triple((light) => light.backdrop.glow) },
  };
}

/** The vector of length one; straight ahead where there is no direction left. */
export function unit([x, y, z]: Triple): Triple {
  const length = Math.hypot(x, y, z);
  return length > 1e-6 ? [x / length, y / length, z / length] : [0, 0, 1];
}
