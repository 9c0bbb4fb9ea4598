/** A worker around a model: it loads, races its backends, then takes one picture at a time. */

import { chooseBackend, type Raced } from "./backend_choice";
import type { FromWorker, ToWorker } from "./landmark_messages";

/** A model in a worker, and what its worker does with a picture. */
export interface ServedModel<Found> extends Raced {
  reset(): void;
  /** What is found in a picture, and what of it is handed over. */
  look(picture: ImageBitmap): Promise<{ found: Found; transfer: Transferable[] }>;
}

type Scope<Found> = {
  postMessage(message: FromWorker<Found>, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
};

/** Serves a model from now on. what: its name for a person; load: makes it, of at most so many faces or hands. */
export function serveModel<Found>(
  what: string,
  load: (most: number, progress: (share: number) => void) => Promise<ServedModel<Found>>,
): void {
  const scope = self as unknown as Scope<Found>;
  let model: ServedModel<Found> | null = null;

  async function start(picture: ImageBitmap, most: number): Promise<void> {
    const tell = (said: string, share: number): void => scope.postMessage({ kind: "loading", what: said, share });
    tell(what, 0);
    model = await load(most, (share) => tell(what, share));
    tell("a first look", 1);
    const chosen = await chooseBackend(model, picture, () => performance.now());
    picture.close();
    model.reset();
    scope.postMessage({ kind: "ready", ...chosen });
  }

  async function look(picture: ImageBitmap, time: number): Promise<void> {
    if (model === null) throw new Error("a picture came before the model was loaded");
    const began = performance.now();
    const { width, height } = picture;
    const { found, transfer } = await model.look(picture);
    picture.close();
    const cost = performance.now() - began;
    scope.postMessage({ kind: "landmarks", time, width, height, cost, ...found }, transfer);
  }

  scope.onmessage = ({ data }) => {
    const done = data.kind === "start" ? start(data.picture, data.most) : look(data.picture, data.time);
    done.catch((error: unknown) => {
      scope.postMessage({ kind: "failed", reason: error instanceof Error ? error.message : String(error) });
    });
  };
}
