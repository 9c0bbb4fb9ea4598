/** The worker of the camera page: pictures in, landmarks out, one at a time. */

import { chooseBackend } from "./backend_choice";
import { faceLight } from "./face_light";
import { FaceMesh } from "./face_mesh";
import type { FromWorker, ToWorker } from "./landmark_messages";

const scope = self as unknown as {
  postMessage(message: FromWorker, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
};
let mesh: FaceMesh | null = null;

async function start(picture: ImageBitmap): Promise<void> {
  const tell = (what: string, share: number): void => scope.postMessage({ kind: "loading", what, share });
  tell("the face model", 0);
  mesh = await FaceMesh.load((share) => tell("the face model", share));
  tell("a first look", 1);
  const chosen = await chooseBackend(mesh, picture, () => performance.now());
  picture.close();
  mesh.reset();
  scope.postMessage({ kind: "ready", ...chosen });
}

async function look(picture: ImageBitmap, time: number): Promise<void> {
  if (mesh === null) throw new Error("a picture came before the model was loaded");
  const began = performance.now();
  const { width, height } = picture;
  const points = await mesh.find(picture);
  const light = faceLight(picture, points);
  picture.close();
  const cost = performance.now() - began;
  scope.postMessage({ kind: "landmarks", time, width, height, points, light, cost }, [points.buffer]);
}

scope.onmessage = ({ data }) => {
  const done = data.kind === "start" ? start(data.picture) : look(data.picture, data.time);
  done.catch((error: unknown) => {
    scope.postMessage({ kind: "failed", reason: error instanceof Error ? error.message : String(error) });
  });
};
