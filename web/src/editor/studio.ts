/** Pictures of (face, expression) off screen, one after the other, on one graphics context. */

import type { Sitting } from "../console/portraits";
import type { Library } from "../link/assets";
import { FaceView } from "../stage/face_view";
import type { Shot } from "../stage/framing";
import { resting } from "../stage/pose";

/** Close on brows, eyes and mouth: what tells one expression from another on a picture as small as a thumb. */
const THUMB: Shot = { centre: [0, -0.014, 0.05], height: 0.185, width: 0.185 };

export class Studio {
  /** What is being drawn; the next picture waits for it. */
  #last: Promise<unknown> = Promise.resolve();

  private constructor(private readonly view: FaceView) {}

  static async open(library: Library): Promise<Studio> {
    const canvas = document.createElement("canvas");
    return new Studio(await FaceView.load(canvas, library, { shot: THUMB, pixelRatio: 1 }));
  }

  /** Rejects when it cannot be drawn. */
  picture(sitting: Sitting, width: number, height: number): Promise<ImageBitmap> {
    const drawn = this.#last.catch(() => undefined).then(() => this.#draw(sitting, width, height));
    this.#last = drawn;
    return drawn;
  }

  async #draw({ face, expression }: Sitting, width: number, height: number): Promise<ImageBitmap> {
    this.view.resize(width, height);
    await this.view.present(resting(face, expression));
    if (!this.view.alive) throw new Error("the graphics context is lost for a moment");
    return createImageBitmap(this.view.canvas);
  }
}
