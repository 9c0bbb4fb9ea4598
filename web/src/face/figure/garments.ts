/** The mix of garments that a character wears, as a texture of fields for the shaders of its body. */

import * as THREE from "three";
import type { FigureSpace } from "../../link/figures";
import type { Look } from "../../link/messages";
import { ROW_SHIFT, ROW_WIDTH } from "../gpu/pass_shaders";

/** What of a look is a number for the shaders of cloth, by the same name. */
export const PATTERNS = ["pinstripes", "checks", "dots"] as const satisfies readonly (keyof Look)[];

/** Uniforms of cloth: fields of its rows (cover, thick, trim, hidden; metres), and how much of each pattern lies on it. */
export type GarmentUniforms = Record<(typeof PATTERNS)[number], THREE.IUniform<number>> & {
  worn: THREE.IUniform<THREE.Texture | null>;
};

export const garmentUniforms = (): GarmentUniforms => ({
  ...(Object.fromEntries(PATTERNS.map((name) => [name, { value: 0 }])) as Omit<GarmentUniforms, "worn">),
  worn: { value: null },
});

/** The garments of one character: fields are linear, so edges slide from where one garment has them to where the next does. */
export class GarmentMix {
  private readonly fields: Float32Array;
  private readonly texture: THREE.DataTexture;
  private readonly garments: FigureSpace["garments"];
  private key = "";

  constructor({ garments, headRows, bodyRows }: FigureSpace) {
    this.garments = garments;
    const height = ((headRows + bodyRows - 1) >> ROW_SHIFT) + 1;
    this.fields = new Float32Array(4 * ROW_WIDTH * height);
    this.texture = new THREE.DataTexture(this.fields, ROW_WIDTH, height, THREE.RGBAFormat, THREE.FloatType);
  }

  /** Mixes garments by weights that sum to one, where they have changed; one that is not there is the first. */
  write(weights: ReadonlyMap<string, number>, into: GarmentUniforms): void {
    into.worn.value = this.texture;
    const key = JSON.stringify([...weights]);
    if (key === this.key) return;
    this.key = key;
    this.fields.fill(0);
    const first = this.garments.values().next().value ?? new Float32Array();
    for (const [name, weight] of weights) {
      const garment = this.garments.get(name) ?? first;
      for (let at = 0; at < garment.length; at++)
        this.fields[at] = (this.fields[at] as number) + weight * (garment[at] as number);
    }
    this.texture.needsUpdate = true;
  }

  dispose(): void {
    this.texture.dispose();
  }
}
