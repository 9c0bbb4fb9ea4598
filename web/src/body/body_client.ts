/** Opens the body's worker, and has the picture of a body that it warms up with. */

import type { Messenger } from "../face_mesh/landmark_client";
import type { BodyFound } from "./body_messages";
import warmUpBody from "./warm_up_body.jpg?no-inline";

/** A worker that finds a body. */
export type BodyWorker = Messenger<BodyFound> & { terminate(): void };

/** Makes a worker that loads nothing before it is started. */
export const openBodyWorker = (): BodyWorker =>
  new Worker(new URL("./body_worker.ts", import.meta.url), { name: "body" });

/** A body for the model's first look. */
export const warmUpBodyPicture = async (): Promise<ImageBitmap> =>
  await createImageBitmap(await (await fetch(warmUpBody)).blob());
