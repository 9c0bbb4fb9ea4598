/** Opens the hand's worker, and has the picture of a hand that it warms up with. */

import type { Messenger } from "../face_mesh/landmark_client";
import type { HandsFound } from "./hand_messages";
import warmUpHand from "./warm_up_hand.jpg?no-inline";

/** A worker that finds hands. */
export type HandWorker = Messenger<HandsFound> & { terminate(): void };

/** Makes a worker that loads nothing before it is started. */
export const openHandWorker = (): HandWorker =>
  new Worker(new URL("./hand_worker.ts", import.meta.url), { name: "hands" });

/** A hand for the model's first look. */
export const warmUpHandPicture = async (): Promise<ImageBitmap> =>
  await createImageBitmap(await (await fetch(warmUpHand)).blob());
