/** Draws thumbnails by two views on canvases of their own: one of faces, and one of figures once a pose is asked for. */

import { capture } from "../face/capture";
import { FaceView, type FaceViewOptions } from "../face/face_view";
import { FIGURE_GROUND, THUMBNAIL } from "../face/framing";
import { restPose, STANDING } from "../face/pose/pose";
import type { Library } from "../link/assets";
import { type DrawThumbnail, THUMBNAIL_SIZE } from "../ui/thumbnails";

export async function openThumbnails(library: Library): Promise<DrawThumbnail> {
  const faces = await openView(library, { shot: THUMBNAIL });
  let figures: Promise<FaceView> | undefined;
  return async ({ face, expression, pose }) => {
    if (pose === undefined) {
      await faces.present(restPose(face, expression));
      return capture(faces);
    }
    figures ??= openView(library, { shotSize: "full", background: FIGURE_GROUND });
    const view = await figures;
    await view.present({ ...restPose(face, expression), figure: { ...STANDING, poses: { [pose]: 1 } } });
    return capture(view);
  };
}

async function openView(library: Library, options: FaceViewOptions): Promise<FaceView> {
  const view = await FaceView.load(document.createElement("canvas"), library, { ...options, pixelRatio: 1 });
  view.resize(THUMBNAIL_SIZE.width, THUMBNAIL_SIZE.height);
  return view;
}
