/** A pose: what a stage draws of a state. */

import { FIRST_LIGHT } from "../../link/constants";
import type { State } from "../../link/messages";

/** What a stage draws: the weights and angles of a state, nothing of its calls. Every `State` is one. */
export type Pose = Pick<State, "faces" | "expressions" | "channels" | "lids" | "head" | "eyes" | "light">;

type Weights = Record<string, number>;

/** The same text for the same pose. */
export const poseKey = ({ faces, expressions, channels, lids, head, eyes, light }: Pose): string =>
  JSON.stringify([faces, expressions, channels, lids, head, eyes, light]);

/** The pose at rest: one face, neutral. */
export const restPose = (face: string, expression = "neutral"): Pose => ({
  faces: { [face]: 1 },
  expressions: { [expression]: 1 },
  channels: {},
  lids: {},
  head: [0, 0, 0],
  eyes: [0, 0, 0, 0],
  light: { [FIRST_LIGHT]: 1 },
});

/** Weights part of the way from `from` to `to`; a name that is missing weighs nothing. */
export function mixWeights(from: Weights, to: Weights, part: number): Weights {
  const mixed: Weights = {};
  for (const name in from) mixed[name] = (from[name] as number) * (1 - part);
  for (const name in to) mixed[name] = (mixed[name] ?? 0) + (to[name] as number) * part;
  return mixed;
}

function mixAngles<T extends number[]>(from: T, to: T, part: number): T {
  return from.map((angle, index) => angle + ((to[index] as number) - angle) * part) as T;
}

/** The pose part of the way (0..1) from `from` to `to`; sums of weights stay what they are. */
export function mixPoses(from: Pose, to: Pose, part: number): Pose {
  return {
    faces: mixWeights(from.faces, to.faces, part),
    expressions: mixWeights(from.expressions, to.expressions, part),
    channels: mixWeights(from.channels, to.channels, part),
    lids: mixWeights(from.lids, to.lids, part),
    head: mixAngles(from.head, to.head, part),
    eyes: mixAngles(from.eyes, to.eyes, part),
    light: mixWeights(from.light, to.light, part),
  };
}

/** The rotation that turns a gaze straight ahead to yaw (+ = +x) and pitch (+ = up), column by column. */
export function writeTurn(yaw: number, pitch: number, into: Float32Array, at: number): void {
  const [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
  into.set([cy, 0, -sy, -sy * sp, cp, -cy * sp, sy * cp, sp, cy * cp], at);
}
