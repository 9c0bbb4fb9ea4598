/** The page's side of the landmark worker: the newest picture is looked at, those that came meanwhile are not. */

import type { FaceFound, FromWorker, LookedAt, ToWorker } from "./landmark_messages";
import type { Backend } from "./solution";
import warmUpFace from "./warm_up_face.jpg?no-inline";

/** How far a model is. */
export type ModelState =
  | { kind: "loading"; what: string; share: number }
  | { kind: "ready"; backend: Backend; cost: number }
  | { kind: "failed"; reason: string };

/** What the page is told. */
export interface LandmarkListener<Found = FaceFound> {
  loading(what: string, share: number): void;
  ready(backend: Backend, cost: number): void;
  landmarks(landmarks: LookedAt & Found): void;
  failed(reason: string): void;
}

/** The part of a worker that is used. */
export interface Messenger<Found = FaceFound> {
  postMessage(message: ToWorker, transfer: Transferable[]): void;
  onmessage: ((event: MessageEvent<FromWorker<Found>>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

/** Makes a worker that loads nothing before it is started. */
export const openLandmarkWorker = (): Worker =>
  new Worker(new URL("./landmark_worker.ts", import.meta.url), { name: "landmarks" });

/** A face for the model's first look. */
export const warmUpPicture = async (): Promise<ImageBitmap> =>
  await createImageBitmap(await (await fetch(warmUpFace)).blob());

/** The worker's state: nothing is sent to one that loads or looks. */
export class LandmarkClient<Found = FaceFound> {
  #busy = true;

  constructor(
    private readonly worker: Messenger<Found>,
    private readonly listener: LandmarkListener<Found>,
  ) {
    worker.onmessage = ({ data }) => this.#receive(data);
    worker.onerror = (event) => listener.failed(event.message || "its script could not be loaded");
  }

  /** Loads the model and has it look at a picture in which there is one; most: how many faces or hands it looks for. */
  start(picture: ImageBitmap, most = 1): void {
    this.worker.postMessage({ kind: "start", picture, most }, [picture]);
  }

  /** Whether a picture would be looked at now. */
  get free(): boolean {
    return !this.#busy;
  }

  /** Has a picture looked at; time: when it was taken, ms. It is closed unseen where the worker is busy. */
  look(picture: ImageBitmap, time: number): void {
    if (this.#busy) {
      picture.close();
      return;
    }
    this.#busy = true;
    this.worker.postMessage({ kind: "picture", picture, time }, [picture]);
  }

  #receive(message: FromWorker<Found>): void {
    if (message.kind === "loading") {
      this.listener.loading(message.what, message.share);
      return;
    }
    this.#busy = message.kind === "failed";
    if (message.kind === "ready") this.listener.ready(message.backend, message.cost);
    else if (message.kind === "landmarks") this.listener.landmarks(message);
    else this.listener.failed(message.reason);
  }
}
