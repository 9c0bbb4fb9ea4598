/** A face of the canvas. */

import type { FaceDocument } from "../../../link/messages";
import type { Bounds } from "../math/camera";
import type { Figure } from "./figure";

/** A face that is shown, or was. */
export interface ShownFace {
  source: string;
  document: FaceDocument;
  figure: Figure;
  bounds: Bounds;
  skinTexture: WebGLTexture;
  block: number;
}
