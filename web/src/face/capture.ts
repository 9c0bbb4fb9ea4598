/** A picture of what a view has drawn, or none where it may be empty. */

import type { FaceView } from "./face_view";

/**
 * What was drawn last, as a picture of its own: to be called in the same task, while the canvas still holds it. Rejects
 * where the graphics context is lost, also where the browser says so only once the picture is made: such a one is empty.
 */
export async function capture(
  view: Pick<FaceView, "canvas" | "alive" | "context">,
  make: (canvas: FaceView["canvas"]) => Promise<ImageBitmap> = createImageBitmap,
): Promise<ImageBitmap> {
  const picture = await make(view.canvas);
  if (view.alive && !view.context.isContextLost()) return picture;
  picture.close();
  throw new Error("the graphics context is lost for a moment");
}
