/** Where hair grows out of the skin: the shade of its roots, row by row. */

import * as THREE from "three";
import type { HairStrands } from "../../link/strands";
import { ROW_WIDTH } from "../gpu/pass_shaders";

/** Metres over which the shade of a root falls to a third. */
const SPREAD = 0.008;
/** Of a style's usual density: from here on the skin between roots is not seen. */
const DENSE = 0.6;

/** How densely a style grows at each row of the skin, 0 none to 1 as over most of the scalp; `positions`: of the face that it was made
 * on, (rows, 3) metres; `skin`: how many rows are skin. */
export function rootDensity(hair: HairStrands, positions: Float32Array, skin: number): Float32Array {
  const density = new Float32Array(positions.length / 3);
  const { anchors, points, stations, fullness } = hair;
  const reach = 3 * SPREAD;
  for (let row = 0; row < skin; row++) {
    const [x, y, z] = [
      positions[3 * row] as number,
      positions[3 * row + 1] as number,
      positions[3 * row + 2] as number,
    ];
    let sum = 0;
    for (let strand = 0; strand < anchors.length; strand++) {
      const at = 3 * strand * stations;
      const up = (points[at + 1] as number) - y;
      if (up > reach || up < -reach) continue;
      const across = (points[at] as number) - x;
      const ahead = (points[at + 2] as number) - z;
      const far = across * across + up * up + ahead * ahead;
      if (far < reach * reach) sum += (fullness[strand] as number) * Math.exp(-far / (SPREAD * SPREAD));
    }
    density[row] = sum;
  }
  const grown = density.filter((sum) => sum > 0).sort();
  const whole = DENSE * (grown[Math.floor(0.75 * grown.length)] ?? 1);
  return density.map((sum) => THREE.MathUtils.smoothstep(sum / whole, 0, 1));
}

/** The mean of densities by their weights, into `into`; nothing where none weighs anything. */
export function mixRoots(parts: readonly (readonly [Float32Array, number])[], into: Float32Array): void {
  const total = parts.reduce((sum, [, weight]) => sum + weight, 0);
  into.fill(0);
  if (total <= 0) return;
  for (const [density, weight] of parts)
    for (let row = 0; row < density.length; row++)
      into[row] = (into[row] as number) + (weight / total) * (density[row] as number);
}

/** A texture for one number a row, as the shaders of the skin read it, and the numbers. */
export function rootsTexture(rows: number): THREE.DataTexture {
  const height = Math.ceil(rows / ROW_WIDTH);
  const texture = new THREE.DataTexture(
    new Float32Array(ROW_WIDTH * height),
    ROW_WIDTH,
    height,
    THREE.RedFormat,
    THREE.FloatType,
  );
  texture.needsUpdate = true;
  return texture;
}
