/** Traits of the eyes that are plain numbers: iris, slit, lashes, pupil. */

import type { FaceDocument } from "../../link/messages";
import type { Documents } from "../pose/head_answer";
import { expressionWeights, faceWeights } from "../pose/mix_terms";
import type { Pose } from "../pose/pose";

/** What of a pose is a number for the shaders: the traits of the faces on air, and how wide the pupils are. */
export interface EyeTraits {
  irisSize: number;
  slit: number;
  lashes: number;
  /** Sum of what expressions and channels add: 1 as wide as pupils go, -1 as narrow; beyond that the shader clamps. */
  pupil: number;
}

/** The traits of a pose: linear in the faces' weights, the pupils in those of expressions and channels around the eyes. */
export function eyeTraitsOf(pose: Pose, { faces, expressions }: Documents): EyeTraits {
  const traits: EyeTraits = { irisSize: 0, slit: 0, lashes: 0, pupil: 0 };
  for (const [name, weight] of faceWeights(pose, (face) => (faces.has(face) ? 1 : 0))) {
    const { iris_size, slit, lashes } = (faces.get(name) as FaceDocument).look;
    traits.irisSize += weight * iris_size;
    traits.slit += weight * slit;
    traits.lashes += weight * lashes;
  }
  for (const [name, weight] of Object.entries(expressionWeights(pose, "eyes")))
    traits.pupil += weight * (expressions.get(name)?.pupil ?? 0);
  return traits;
}

/** Writes the traits of a pose for the next frame. */
export function writeEyeTraits(traits: EyeTraits, into: { [name in keyof EyeTraits]: { value: number } }): void {
  for (const name of Object.keys(traits) as (keyof EyeTraits)[]) into[name].value = traits[name];
}
