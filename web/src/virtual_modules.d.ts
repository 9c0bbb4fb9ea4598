/** Modules that the build makes. */

declare module "virtual:face_mesh" {
  /** The folder of MediaPipe's files at the server, with a slash at its end. */
  export const FACE_MESH: string;
}

declare module "virtual:hands" {
  /** The folder of the hand model's files at the server, with a slash at its end. */
  export const HANDS: string;
}

declare module "virtual:pose" {
  /** The folder of the body model's files at the server, with a slash at its end. */
  export const POSE: string;
}
