/** The mesh and material of an eyeball. */

import * as THREE from "three";
import type { Anatomy } from "../anatomy/anatomy";
import { ballFrame, dome } from "../anatomy/eye_mesh";
import { type Opening, opening, outline } from "../anatomy/openings";
import { material, type Uniforms } from "../gpu/renderer";
import { EYE_FRAGMENT, EYE_VERTEX } from "./eye_shaders";

/** Rings and spokes of a drawn eyeball, near and far from what the machine can do. */
const FINE: [number, number] = [26, 40];
const COARSE: [number, number] = [12, 18];

/** The rows of an opening's edges, for the shaders; whole numbers in a row, which are handed over every frame. */
export const edgeUniforms = ({ upper, lower }: Opening): Uniforms => ({
  upperRows: { value: Int32Array.from(upper) },
  lowerRows: { value: Int32Array.from(lower) },
});

/** An eyeball, left (0) or right (1), as it is drawn: a fine dome on the axes of the cast's own coarse ball. */
export function eyeball(side: 0 | 1, anatomy: Anatomy, uniforms: Uniforms, fast: boolean): THREE.Mesh {
  const { directions, triangles } = dome(...(fast ? COARSE : FINE));
  const geometry = new THREE.BufferGeometry();
  geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
  geometry.setAttribute("direction", new THREE.BufferAttribute(directions, 3));
  const [first, end] = [anatomy.eyeRows[2 * side] as number, anatomy.eyeRows[2 * side + 1] as number];
  const { rows, fromPairs } = ballFrame(anatomy.positions, first, end);
  const look = material(EYE_VERTEX, EYE_FRAGMENT, {
    ...uniforms,
    ...edgeUniforms(lids(side, anatomy, rows)),
    frameRows: { value: Int32Array.from(rows) },
    fromPairs: { value: new THREE.Matrix3().fromArray(fromPairs) },
  });
  return new THREE.Mesh(geometry, look);
}

/** The lids' edges; an eye whose cast names none has the ball's own outline, so it is wide open. */
function lids(side: 0 | 1, anatomy: Anatomy, ball: readonly number[]): Opening {
  const line = anatomy.lines.get(side === 0 ? "lid_left" : "lid_right") ?? outline(ball, anatomy.positions);
  return opening([...line], anatomy.positions);
}
