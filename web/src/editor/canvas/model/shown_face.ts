/** A face of the canvas. */

import type { FaceDocument } from "../../../link/messages";
import type { Bounds } from "../math/camera";
import type { Figure } from "./figure";

/** A face that is shown, or was. */
export interface ShownFace {
  source: string;
  document: FaceDocument;
  figure: Figure;
  /** At rest, (rows, 3) metres: what its hair is posed on. */
  rest: Float32Array;
  bounds: Bounds;
  skinTexture: WebGLTexture;
  block: number;
}
