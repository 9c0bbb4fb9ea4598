/** The page's side of the worker that finds landmarks in photographs: it is made when the first one comes. */

import type { FromPhotographWorker } from "./photograph_worker";

/** The part of a worker that is used. */
export interface PhotographMessenger {
  postMessage(message: ImageBitmap, transfer: Transferable[]): void;
  onmessage: ((event: MessageEvent<FromPhotographWorker>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  terminate(): void;
}

const makeWorker = (): PhotographMessenger =>
  new Worker(new URL("./photograph_worker.ts", import.meta.url), { name: "photographs" });

export class PhotographFinder {
  #worker: PhotographMessenger | null = null;

  /** progress: called with how much of the model has come, 0..1. */
  constructor(
    private readonly progress: (share: number) => void,
    private readonly make: () => PhotographMessenger = makeWorker,
  ) {}

  /** The points of the face in a picture, x, y and z of each, none where there is no face; one picture at a time. */
  find(picture: ImageBitmap): Promise<Float32Array> {
    this.#worker ??= this.make();
    const worker = this.#worker;
    return new Promise((resolve, reject) => {
      const fail = (reason: string): void => reject(new Error(`The face model does not run here: ${reason}.`));
      worker.onmessage = ({ data }) => {
        if (data.kind === "loading") this.progress(data.share);
        else if (data.kind === "found") resolve(data.points);
        else fail(data.reason);
      };
      worker.onerror = (event) => fail(event.message || "its script could not be loaded");
      worker.postMessage(picture, [picture]);
    });
  }

  /** Ends the worker, with what it has loaded. */
  close(): void {
    this.#worker?.terminate();
    this.#worker = null;
  }
}
