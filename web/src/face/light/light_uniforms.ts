/** The light as uniforms of all materials of the head. */

import * as THREE from "three";
import type { Light } from "./lights";
import type { Triple } from "./tone";

const vector = (): THREE.IUniform<THREE.Vector3> => ({ value: new THREE.Vector3() });
const number = (value = 0): THREE.IUniform<number> => ({ value });

/** The light as uniforms that all materials of the head share, by the names in `shader_prelude.ts`. */
export const lightUniforms = () => ({
  KEY: vector(),
  FILL: vector(),
  RIM_LEFT: vector(),
  RIM_RIGHT: vector(),
  KEY_LIGHT: vector(),
  FILL_LIGHT: vector(),
  RIM_LIGHT: vector(),
  SKY_LIGHT: vector(),
  GROUND_LIGHT: vector(),
  SHADE: number(1),
  EXPOSURE: number(1),
});

export type LightUniforms = ReturnType<typeof lightUniforms>;

/** Writes a light for the next frame. */
export function writeLight(light: Light, into: LightUniforms): void {
  const put = (uniform: THREE.IUniform<THREE.Vector3>, [x, y, z]: Triple) => uniform.value.set(x, y, z);
  put(into.KEY, light.key.from);
  put(into.FILL, light.fill.from);
  put(into.RIM_LEFT, light.rims.left);
  put(into.RIM_RIGHT, light.rims.right);
  put(into.KEY_LIGHT, light.key.light);
  put(into.FILL_LIGHT, light.fill.light);
  put(into.RIM_LIGHT, light.rims.light);
  put(into.SKY_LIGHT, light.sky);
  put(into.GROUND_LIGHT, light.ground);
  into.SHADE.value = light.shade;
  into.EXPOSURE.value = light.exposure;
}
