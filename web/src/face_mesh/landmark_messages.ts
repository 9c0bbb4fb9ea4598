/** What a page and its landmark workers say to each other. */

import type { Backend } from "./solution";

/** What the page sends: the picture to warm up with and how many are looked for, then one picture of the camera at a time. */
export type ToWorker =
  | { kind: "start"; picture: ImageBitmap; most: number }
  | { kind: "picture"; picture: ImageBitmap; time: number };

/** A picture that was looked at. time: of the page's clock, ms; cost: what the model took, ms. */
export interface LookedAt {
  time: number;
  width: number;
  height: number;
  cost: number;
}

/** What is found of a face. */
export interface FaceFound {
  /** x, y, z of each point, empty where no face is in the picture. */
  points: Float32Array<ArrayBuffer>;
  /** How light the picture is around the face, 0..1. */
  light: number;
}

/** A picture's landmarks of a face. */
export type Landmarks = LookedAt & FaceFound;

/** What a worker answers, by what it finds. */
export type FromWorker<Found = FaceFound> =
  | { kind: "loading"; what: string; share: number }
  | { kind: "ready"; backend: Backend; cost: number }
  | ({ kind: "landmarks" } & LookedAt & Found)
  | { kind: "failed"; reason: string };
