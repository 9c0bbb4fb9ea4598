/** Where a face's eyeballs stand and where they look. */

import type { Anatomy } from "../../../face/anatomy/anatomy";
import { type BallFrame, ballFrame } from "../../../face/anatomy/eye_mesh";
import { writeTurn } from "../../../face/pose/pose";
import type { Recipe } from "../../../link/editing_messages";
import type { Manifest } from "../../../link/messages";
import type { Box } from "../math/boxes";
import { overlap } from "../math/boxes";
import type { Camera } from "../math/camera";
import { add, minus, rowOf, type Triple, times } from "../math/vectors";

/** An eyeball as it stands: its centre, and its axes times its radius, turned, column by column. */
export interface Ball {
  centre: Float32Array;
  axes: Float32Array;
}

/** What the hand sets of the eyes (`DraftStore.liveEyes`). */
interface Gaze {
  turns: readonly number[];
  pupil: number;
}

/** How to read each eyeball's axes from its rows. */
export const ballFrames = (anatomy: Anatomy): BallFrame[] =>
  [0, 1].flatMap((side) => {
    const [first, end] = [anatomy.eyeRows[2 * side] as number, anatomy.eyeRows[2 * side + 1] as number];
    return end > first ? [ballFrame(anatomy.positions, first, end)] : [];
  });

/** The eyeballs of a face, turned by angles (left yaw, pitch, right yaw, pitch; radians). */
export function ballsOf(frames: readonly BallFrame[], positions: Float32Array, angles: readonly number[]): Ball[] {
  return frames.map(({ rows, fromPairs }, side) => {
    const ends = rows.map((row) => rowOf(positions, row)) as [Triple, Triple, Triple, Triple, Triple, Triple];
    const centre = times(ends.reduce(add), 1 / 6);
    const halves = [0, 2, 4].flatMap((n) => times(minus(ends[n] as Triple, ends[n + 1] as Triple), 0.5));
    const turn = new Float32Array(9);
    writeTurn(angles[2 * side] ?? 0, angles[2 * side + 1] ?? 0, turn, 0);
    return { centre: Float32Array.from(centre), axes: times3(turn, times3(halves, fromPairs)) };
  });
}

/** Whether an eyeball may show in a part of the canvas. */
export function shows({ centre, axes }: Ball, camera: Camera, part: Box): boolean {
  const middle = rowOf(centre, 0);
  const [x, y] = camera.project(middle);
  const reach =
    (1.1 * Math.hypot(axes[0] as number, axes[1] as number, axes[2] as number)) / camera.metresPerPixel(middle);
  const { width, height } = overlap({ left: x - reach, top: y - reach, width: 2 * reach, height: 2 * reach }, part);
  return width > 0 && height > 0;
}

/** a @ b, both (3, 3) column by column. */
function times3(a: ArrayLike<number>, b: ArrayLike<number>): Float32Array {
  return Float32Array.from({ length: 9 }, (_, at) => {
    const [column, row] = [Math.floor(at / 3), at % 3];
    return [0, 1, 2].reduce((sum, n) => sum + (a[3 * n + row] as number) * (b[3 * column + n] as number), 0);
  });
}

/** Angles and pupils that a recipe adds up to, with what the hand sets now, as far as the cast's documents tell. */
export function gazeOf(recipe: Recipe | null, hand: Gaze, manifest: Manifest): { angles: number[]; pupil: number } {
  if (recipe === null) return { angles: [0, 0, 0, 0], pupil: 0 };
  const angles: number[] = [...hand.turns];
  let { pupil } = hand;
  for (const { source, weight, region, mirrored, muted } of recipe.layers) {
    if (muted) continue;
    const known = manifest.expressions.find((one) => one.source === source);
    if (known === undefined || (region !== null && region !== "eyes")) continue;
    const [leftYaw, leftPitch, rightYaw, rightPitch] = known.eyes;
    const worn = [leftYaw, leftPitch, rightYaw, rightPitch];
    if (mirrored) worn.splice(0, 4, -rightYaw, rightPitch, -leftYaw, leftPitch);
    worn.forEach((angle, at) => {
      angles[at] = (angles[at] as number) + weight * angle;
    });
    pupil += weight * known.pupil;
  }
  return { angles, pupil };
}
