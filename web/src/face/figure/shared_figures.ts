/** What all figures of a cast share: their space, its skeleton, the names of bodies. */

import type { Library } from "../../link/assets";
import type { Body, FigureSpace } from "../../link/figures";
import { type Skeleton, skeletonOf } from "./skeleton";

/** What all figures of a cast share. */
export interface SharedFigures {
  readonly space: FigureSpace;
  readonly skeleton: Skeleton;
  /** Names of the bodies, and by how much each is drawn larger than its person is. */
  readonly bodies: ReadonlyMap<string, number>;
  /** The body that others are shaped from. */
  readonly first: Body;
}

/** What all figures of a library's cast share; undefined where it has none. */
export async function loadFigures(library: Library): Promise<SharedFigures | undefined> {
  const listed = library.manifest.figures?.bodies ?? [];
  if (listed[0] === undefined) return undefined;
  const [space, first] = await Promise.all([library.figures(), library.body(listed[0].name)]);
  return { space, skeleton: skeletonOf(space), bodies: new Map(listed.map(({ name, size }) => [name, size])), first };
}
