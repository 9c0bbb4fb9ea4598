/** Where characters stand: places as matrices, and how a character comes into the picture. */

import type { Matrix4 } from "three";
import { Vector3 } from "three";
import type { Place } from "../link/messages";
import type { Point, Shot } from "./framing";

/** Where a place's turn and size leave a head: between its ears, metres. */
const AXIS = 0.03;

/** Hair above the highest point of a head, and air over it, metres. */
const OVER = 0.06;

/** The matrix of a place: from metres of the head to metres of the stage; `drop`: metres lower, as who comes or goes. */
export function placeMatrix({ x, depth, size, turn }: Place, drop: number, into: Matrix4): Matrix4 {
  const [across, ahead] = [size * Math.cos(turn), size * Math.sin(turn)];
  return into.set(
    ...[across, 0, ahead, x - ahead * AXIS],
    ...[0, size, 0, -drop],
    ...[-ahead, 0, across, AXIS - depth - across * AXIS],
    ...[0, 0, 0, 1],
  );
}

/** A shot of a head, and its points, where the head stands. */
export function placed(shot: Shot, points: readonly Point[], { size }: Place, matrix: Matrix4) {
  const at = (point: Point): [number, number, number] => new Vector3(...point).applyMatrix4(matrix).toArray();
  const { centre, height, width } = shot;
  return { shot: { centre: at(centre), height: height * size, width: width * size }, points: points.map(at) };
}

/**
 * Metres that a head with these points stands lower while it comes: it rises from below the picture, where the bust is cut
 * off anyway, and crosses nobody. `camera`: where it stands; `half`: half the height that it sees a metre away.
 */
export function dropOf(presence: number, points: readonly Point[], size: number, camera: Point, half: number): number {
  const under = points.map(([, y, z]) => y + OVER * size - (camera[1] - half * (camera[2] - z)));
  return (1 - presence) * Math.max(0, ...under);
}
