/** What the page and its landmark worker say to each other. */

import type { Backend } from "./face_mesh";

/** What the page sends: the picture to warm up with, then one picture of the camera at a time. */
export type ToWorker =
  | { kind: "start"; picture: ImageBitmap }
  | { kind: "picture"; picture: ImageBitmap; time: number };

/** A picture's landmarks. time: of the page's clock, ms; points: x, y, z of each, empty where no face is in it. */
export interface Landmarks {
  time: number;
  width: number;
  height: number;
  points: Float32Array<ArrayBuffer>;
  /** How light the picture is around the face, 0..1. */
  light: number;
  /** What the model took, ms. */
  cost: number;
}

/** What the worker answers. */
export type FromWorker =
  | { kind: "loading"; what: string; share: number }
  | { kind: "ready"; backend: Backend; cost: number }
  | ({ kind: "landmarks" } & Landmarks)
  | { kind: "failed"; reason: string };
