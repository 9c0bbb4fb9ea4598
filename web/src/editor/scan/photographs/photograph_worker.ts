/** The worker that finds landmarks in photographs, one after the other, on the processor. */

import { FaceMesh } from "../../../face_mesh/face_mesh";

/** What the worker answers: how much of the model has come, 0..1; a picture's points, none without a face; why not. */
export type FromPhotographWorker =
  | { kind: "loading"; share: number }
  | { kind: "found"; points: Float32Array<ArrayBuffer> }
  | { kind: "failed"; reason: string };

const scope = self as unknown as {
  postMessage(message: FromPhotographWorker, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent<ImageBitmap>) => void) | null;
};
let model: Promise<FaceMesh> | null = null;

async function look(picture: ImageBitmap): Promise<void> {
  model ??= FaceMesh.load((share) => scope.postMessage({ kind: "loading", share }));
  const mesh = await model;
  mesh.reset();
  await mesh.find(picture); // the first look finds where the face is, the second begins there
  const points = await mesh.find(picture);
  picture.close();
  scope.postMessage({ kind: "found", points }, [points.buffer]);
}

scope.onmessage = ({ data }) => {
  look(data).catch((error: unknown) => {
    scope.postMessage({ kind: "failed", reason: error instanceof Error ? error.message : String(error) });
  });
};
