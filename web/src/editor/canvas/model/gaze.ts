/** Where a face's eyeballs stand and where they look. */

import type { BallFrame } from "../../../face/anatomy/eye_mesh";
import type { Recipe } from "../../../link/editing_messages";
import type { Manifest } from "../../../link/messages";
import { type Box, overlap } from "../math/boxes";
import type { Camera } from "../math/camera";
import { add, minus, rowOf, size, type Triple, times } from "../math/vectors";

/** An eyeball as it stands, metres. */
export interface Ball {
  centre: Triple;
  radius: number;
}

/** Where eyes look (left yaw, pitch, right yaw, pitch; radians), and how wide pupils are. */
export interface Gaze {
  angles: readonly number[];
  pupil: number;
}

/** The eyeball that is read from these rows of a face. */
export function ballOf({ rows }: Pick<BallFrame, "rows">, positions: Float32Array): Ball {
  const ends = rows.map((row) => rowOf(positions, row));
  const far = [0, 2, 4].map((n) => size(minus(ends[n] as Triple, ends[n + 1] as Triple)));
  return { centre: times(ends.reduce(add), 1 / 6), radius: Math.max(...far) / 2 };
}

/** Whether an eyeball may show in a part of the canvas. */
export function shows({ centre, radius }: Ball, camera: Camera, part: Box): boolean {
  const [x, y] = camera.project(centre);
  const reach = (1.1 * radius) / camera.metresPerPixel(centre);
  const { width, height } = overlap({ left: x - reach, top: y - reach, width: 2 * reach, height: 2 * reach }, part);
  return width > 0 && height > 0;
}

/** Angles and pupils that a recipe adds up to, with what the hand sets now, as far as the cast's documents tell. */
export function gazeOf(
  recipe: Recipe | null,
  hand: { turns: readonly number[]; pupil: number },
  manifest: Manifest,
): Gaze {
  if (recipe === null) return { angles: [0, 0, 0, 0], pupil: 0 };
  const angles: number[] = [...hand.turns];
  let { pupil } = hand;
  for (const { source, weight, region, mirrored, muted } of recipe.layers) {
    if (muted) continue;
    const expression = manifest.expressions.find((candidate) => candidate.source === source);
    if (expression === undefined || (region !== null && region !== "eyes")) continue;
    const [leftYaw, leftPitch, rightYaw, rightPitch] = expression.eyes;
    const worn = [leftYaw, leftPitch, rightYaw, rightPitch];
    if (mirrored) worn.splice(0, 4, -rightYaw, rightPitch, -leftYaw, leftPitch);
    worn.forEach((angle, at) => {
      angles[at] = (angles[at] as number) + weight * angle;
    });
    pupil += weight * expression.pupil;
  }
  return { angles, pupil };
}
