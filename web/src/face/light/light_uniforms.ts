/** The light as uniforms of all materials of the head. */

import * as THREE from "three";
import type { Light } from "./lights";

/** What of a light the shaders take as vectors, by the names in `shader_prelude.ts`. */
const VECTORS = {
  KEY: ({ key }: Light) => key.direction,
  FILL: ({ fill }: Light) => fill.direction,
  RIM_LEFT: ({ rims }: Light) => rims.left,
  RIM_RIGHT: ({ rims }: Light) => rims.right,
  KEY_LIGHT: ({ key }: Light) => key.colour,
  FILL_LIGHT: ({ fill }: Light) => fill.colour,
  RIM_LIGHT: ({ rims }: Light) => rims.colour,
  SKY_LIGHT: ({ sky }: Light) => sky,
  GROUND_LIGHT: ({ ground }: Light) => ground,
};
type Name = keyof typeof VECTORS;
const NAMES = Object.keys(VECTORS) as Name[];

/** The light as uniforms that all materials of the head share, by the names in `shader_prelude.ts`. */
export const lightUniforms = () => ({
  ...(Object.fromEntries(NAMES.map((name) => [name, { value: new THREE.Vector3() }])) as Record<
    Name,
    THREE.IUniform<THREE.Vector3>
  >),
  SHADE: { value: 1 },
  EXPOSURE: { value: 1 },
});

export type LightUniforms = ReturnType<typeof lightUniforms>;

/** Writes a light for the next frame. */
export function writeLight(light: Light, into: LightUniforms): void {
  for (const name of NAMES) into[name].value.set(...VECTORS[name](light));
  into.SHADE.value = light.shade;
  into.EXPOSURE.value = light.exposure;
}
