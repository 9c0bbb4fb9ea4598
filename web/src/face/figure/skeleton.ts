/** The bones of a figure by their names, as `model.body.skeleton` has them. */

import type { FigureSpace } from "../../link/figures";

export const SIDES = ["L", "R"] as const;
export type Side = (typeof SIDES)[number];

/** Of one side, each the parent of the next; a limb's second bone lies along its first. */
export const LEG = ["pelvis", "upperleg01", "upperleg02", "lowerleg01", "lowerleg02", "foot", "toes"] as const;

/** A skeleton: bones in an order in which a parent stands before its children, and the place of each. */
export interface Skeleton {
  readonly names: readonly string[];
  readonly parents: readonly number[];
  readonly places: ReadonlyMap<string, number>;
}

/** The skeleton of a space of figures. */
export const skeletonOf = ({ bones, parents }: FigureSpace): Skeleton => ({
  names: bones,
  parents: Array.from(parents),
  places: new Map(bones.map((name, place) => [name, place])),
});

/** The place of a bone; an Error where the skeleton has none of that name. */
export function placeOf({ places }: Skeleton, name: string): number {
  const place = places.get(name);
  if (place === undefined) throw new Error(`The figures have no bone "${name}"; bake the cast again.`);
  return place;
}

/** The region that a bone belongs to, by its name (`model.body.pose_regions`). */
export function regionOf(bone: string): "head" | "trunk" | "arm_left" | "arm_right" | "stance" {
  if (/^(head|neck)/.test(bone)) return "head";
  if (bone.startsWith("spine")) return "trunk";
  if (/^(root|pelvis|upperleg|lowerleg|foot|toes)/.test(bone)) return "stance";
  return bone.endsWith(".L") ? "arm_left" : "arm_right";
}
