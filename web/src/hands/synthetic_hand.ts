/** A hand of straight joints for tests: points as a model finds them, of what a hand does, turned, before a lens. */

import type { HandAxes } from "./hand_guide";
import { type FoundHand, HAND_POINTS, type Hands } from "./hand_messages";

/** Where a hand is: the wrist in the picture, metres from the lens. */
export interface HandPlace {
  x?: number;
  y?: number;
  side?: "left" | "right";
}

export const STILL: HandAxes = { opening: 0, index: 0, little: 0, yaw: 0, pitch: 0, roll: 0 };

type Triple = [number, number, number];

/** The points of a hand along its palm's axes (width, fingers, normal), metres. */
function palmPoints({ opening, index, little }: HandAxes): Triple[] {
  const points: Triple[] = [[0, 0, 0]];
  const thumb = 0.9 - 0.5 * opening;
  for (const length of [0.03, 0.06, 0.085, 0.105]) {
    points.push([0.02, length * Math.cos(thumb) * 0.9, length * Math.sin(thumb) + 0.01]);
  }
  [0.025, 0, -0.018, -0.035].forEach((width, finger) => {
    const curl = [index, 0.8 * index, 0.8 * little, little][finger] ?? 0;
    let [along, normal, bend] = [0.09 - 0.004 * finger, 0, 0.9 - 0.8 * opening + 0.2 * curl];
    points.push([width, along, normal]);
    for (const length of [0.04, 0.025, 0.02]) {
      along += length * Math.cos(bend);
      normal += length * Math.sin(bend);
      points.push([width, along, normal]);
      bend += 0.3 + 0.35 * curl;
    }
  });
  return points;
}

/** The turn of the wrist, about the palm's own axes: yaw about the normal, pitch about the width, roll about the fingers. */
function turned([x, y, z]: Triple, { yaw, pitch, roll }: HandAxes): Triple {
  const [a, b, c] = [0.4 * yaw, 0.4 * pitch, 0.4 * roll];
  const [x1, z1] = [x * Math.cos(c) + z * Math.sin(c), -x * Math.sin(c) + z * Math.cos(c)];
  const [y2, z2] = [y * Math.cos(b) - z1 * Math.sin(b), y * Math.sin(b) + z1 * Math.cos(b)];
  return [x1 * Math.cos(a) - y2 * Math.sin(a), x1 * Math.sin(a) + y2 * Math.cos(a), z2];
}

/** A hand in profile: its width goes away from the lens, its fingers to the right of the picture, its normal down. */
export function syntheticHand(axes: HandAxes, { x = 0.4, y = 0.5, side = "right" }: HandPlace = {}): FoundHand {
  const image = new Float32Array(3 * HAND_POINTS);
  const world = new Float32Array(3 * HAND_POINTS);
  palmPoints(axes).forEach((point, row) => {
    const [width, along, normal] = turned(point, axes);
    const [right, down, away] = [along, normal, width];
    const depth = 0.45 + away;
    world.set([right, down, away], 3 * row);
    image.set([x + (0.95 * right) / depth, y + ((0.95 * down) / depth) * (4 / 3), (0.95 * away) / 0.45], 3 * row);
  });
  return { image, world, side, score: 0.98 };
}

/** A picture with some hands. time: seconds. */
export const syntheticPicture = (time: number, ...hands: FoundHand[]): Hands => ({
  time: 1000 * time,
  width: 640,
  height: 480,
  cost: 40,
  hands,
});

/** Numbers between 0 and 1 that are the same each time. */
export function seededNumbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}
