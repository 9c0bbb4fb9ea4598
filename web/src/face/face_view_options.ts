/** What a view of faces may be told when it is made. */

import type { Shot, Tile } from "./framing";
import type { Triple } from "./light/tone";
import type { Level } from "./quality/quality_levels";

/** How a view draws; everything may be left out. */
export interface FaceViewOptions {
  /** The page shows through (premultiplied alpha), no backdrop. */
  transparent?: boolean;
  /** A colour behind the head, in linear light, instead of the light's own. */
  background?: Triple | undefined;
  /** A light instead of the pose's. */
  light?: string | undefined;
  /** This view's place on a wall. */
  tile?: Tile | undefined;
  /** Device pixels per CSS pixel, at most. */
  pixelRatio?: number;
  /** What the picture may cost; by default what suits the machine. */
  level?: Level | undefined;
  shot?: Shot;
}
