/** Pictures of (face, expression) off screen, one after the other, on one graphics context. */

import { capture } from "../../face/capture";
import { FaceView, type FaceViewOptions } from "../../face/face_view";
import { FIGURE_GROUND, PORTRAIT, THUMBNAIL } from "../../face/framing";
import { fenced } from "../../face/gpu/fence";
import { restPose, STANDING } from "../../face/pose/pose";
import { KEY, type Library } from "../../link/assets";
import type { FaceDocument, Look, Manifest } from "../../link/messages";
import type { ThumbnailSubject } from "../../ui/thumbnails";
import { loadFace } from "./asset_loading";

/** Yaw, pitch, roll: how a head is turned to show its hair behind too, radians. */
const HALF_LEFT = [0.75, 0, 0] as [number, number, number];

/** Milliseconds between two looks at whether the graphics processor has drawn. */
const LOOK = 8;

export class ThumbnailRenderer {
  /** What is being drawn; the next picture waits for it. */
  #last: Promise<unknown> = Promise.resolve();

  /** Draws figures, once a picture of one is asked for. */
  #figures: Promise<FaceView> | undefined;

  private constructor(private readonly view: FaceView) {}

  /** Draws at the cheapest level: pictures as small as these look alike at all. */
  static async open(library: Library): Promise<ThumbnailRenderer> {
    return new ThumbnailRenderer(await openView(library, { shot: THUMBNAIL }));
  }

  /** Rejects when it cannot be drawn. */
  picture(sitting: ThumbnailSubject, width: number, height: number): Promise<ImageBitmap> {
    const drawn = this.#last.catch(() => undefined).then(() => this.#draw(sitting, width, height));
    this.#last = drawn;
    return drawn;
  }

  async #draw(subject: ThumbnailSubject, width: number, height: number): Promise<ImageBitmap> {
    const { face, expression, hair, pose: done } = subject;
    if (done !== undefined) return this.#drawFigure(face, done, width, height);
    const { view } = this;
    await ensureFace(view.library, face);
    view.shot = hair === undefined ? THUMBNAIL : PORTRAIT;
    view.resize(width, height);
    const pose = restPose(hair === undefined ? face : wearing(view.library, face, hair), expression);
    await view.present(hair === undefined ? pose : { ...pose, head: HALF_LEFT });
    const [picture] = await Promise.all([capture(view), finished(view.context)]);
    return picture;
  }

  async #drawFigure(face: string, pose: string, width: number, height: number): Promise<ImageBitmap> {
    this.#figures ??= openView(this.view.library, { shotSize: "full", background: FIGURE_GROUND });
    const view = await this.#figures;
    view.resize(width, height);
    await view.present({ ...restPose(face), figure: { ...STANDING, poses: { [pose]: 1 } } });
    const [picture] = await Promise.all([capture(view), finished(view.context)]);
    return picture;
  }
}

const openView = (library: Library, options: FaceViewOptions): Promise<FaceView> =>
  FaceView.load(document.createElement("canvas"), library, { ...options, pixelRatio: 1, level: "lowest" });

/**
 * Makes a face known that the cast has not, or not yet: one that was saved a moment ago, an old revision, a deleted one.
 * Without its look it would be drawn black.
 */
export async function ensureFace(library: Library, face: string, load = loadFace): Promise<void> {
  if (library.hasFace(face) || library.sourceOf("faces", face) !== face) return;
  if (!face.startsWith(KEY)) throw new Error(`There is no face "${face}" in this cast.`);
  const { document } = await load(library.manifest, face);
  library.faces.set(face, document);
}

/** Makes a face known that is another with another hair style, "" for none, and on its scalp the shade that goes with
 * that; its name. The face must be known. */
export function wearing(library: Library, face: string, style: string): string {
  const own = library.faces.get(library.sourceOf("faces", face)) as FaceDocument;
  if (own.look.hair_style === style) return own.source;
  const name = `${own.source} with ${style}`;
  library.faces.set(name, { ...own, look: { ...own.look, ...hairOf(library.manifest, style) } });
  return name;
}

/** What a look says of a hair style, "" for none: its name, and the shade on the scalp that goes with it. */
export const hairOf = ({ hair }: Manifest, style: string): Pick<Look, "hair_style" | "scalp"> => ({
  hair_style: style,
  scalp: hair.find(({ name }) => name === style)?.scalp ?? 0,
});

/** Waits without blocking until the graphics processor has drawn: on slow ones the page stays usable meanwhile. */
async function finished(gl: WebGL2RenderingContext): Promise<void> {
  const done = fenced(gl);
  while (!gl.isContextLost() && !done()) await new Promise((done) => setTimeout(done, LOOK));
}
