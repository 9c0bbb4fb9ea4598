/** Draws thumbnails of faces by one view on a canvas of its own: one graphics context for all of them. */

import { capture } from "../face/capture";
import { FaceView } from "../face/face_view";
import { THUMBNAIL } from "../face/framing";
import { restPose } from "../face/pose/pose";
import type { Library } from "../link/assets";
import { type DrawThumbnail, THUMBNAIL_SIZE } from "../ui/thumbnails";

export async function openThumbnails(library: Library): Promise<DrawThumbnail> {
  const view = await FaceView.load(document.createElement("canvas"), library, { shot: THUMBNAIL, pixelRatio: 1 });
  view.resize(THUMBNAIL_SIZE.width, THUMBNAIL_SIZE.height);
  return async ({ face, expression }) => {
    await view.present(restPose(face, expression));
    return capture(view);
  };
}
