/** Where needles stand on the canvas, and which of them a pointer means. */

import { type Fans, normalAt } from "../../../face/anatomy/topology";
import type { Camera } from "../math/camera";
import { hit } from "../math/hit_test";
import { add, dot, minus, rowOf, size, type Triple, times, unit } from "../math/vectors";

/** Metres that a handle's head stands out of the skin. */
export const STUD = 0.002;

/** Metres that a needle stands out of the skin on a head of ordinary size. */
export const NEEDLE = 0.0035;
/** CSS pixels around a needle's head that belong to it, by mouse or pen, and by finger. */
export const REACH = { mouse: 11, touch: 26 } as const;
/** Metres by which skin may lie before a needle's head without hiding it: lips before their own line. */
export const SLACK = 0.004;
/** A needle that points away from the camera by more than this is hidden (cosine). */
const TURNED_AWAY = -0.12;

/** A needle as it stands on a face: its foot on the skin, and its head. */
export interface Needle {
  place: number;
  foot: Triple;
  head: Triple;
  outward: Triple;
}

/** How much a needle points away from the axis where the skin around it points anywhere: on lines of lips and lids. */
const RADIAL = 2;
/** The cylinder's axis (conventions.md), metres. */
const AXIS = 0.02;

/** Where a needle points: as the skin around its row does, and away from the head's axis. */
export function outwardAt(fans: Fans, positions: Float32Array, row: number): Triple {
  const [x, , z] = rowOf(positions, row);
  const radial = unit([x, 0, z - AXIS]);
  let [sum, count] = [normalAt(fans, positions, row), 1];
  for (let slot = fans.starts[row] as number; slot < (fans.starts[row + 1] as number); slot++, count++)
    sum = add(sum, normalAt(fans, positions, fans.pairs[2 * slot] as number));
  const agreed = size(sum) / count; // 1 where the skin is smooth
  return unit(add(times(sum, 1 / count), times(radial, RADIAL * (1 - agreed))));
}

/** The needles of some rows of a face. */
export function needlesOn(rows: readonly number[], fans: Fans, positions: Float32Array, length = NEEDLE): Needle[] {
  return rows.map((row, place) => {
    const [foot, outward] = [rowOf(positions, row), outwardAt(fans, positions, row)];
    return { place, foot, outward, head: add(foot, times(outward, length)) };
  });
}

/** What may hide needles. */
export interface HidingSkin {
  positions: Float32Array;
  triangles: Uint32Array;
}

/** Whether the camera sees a needle's head. */
export function seen(needle: Needle, camera: Camera, skin: HidingSkin): boolean {
  const ray = minus(needle.head, camera.eye);
  const far = Math.hypot(...ray);
  const direction = times(ray, 1 / far);
  if (dot(needle.outward, direction) > -TURNED_AWAY) return false;
  const before = hit(skin.positions, skin.triangles, camera.eye, direction);
  return before === undefined || before.distance > far - SLACK;
}

/** The needle that a pointer at (x, y) means: the nearest head within reach that the camera sees; undefined: none. */
export function picked(
  needles: readonly Needle[],
  camera: Camera,
  skin: HidingSkin,
  pointer: readonly [x: number, y: number],
  reach: number,
): Needle | undefined {
  const near = needles
    .map((needle) => ({ needle, far: farFrom(needle, camera, pointer) }))
    .filter(({ far }) => far <= reach)
    .sort((a, b) => a.far - b.far);
  return near.find(({ needle }) => seen(needle, camera, skin))?.needle;
}

/** Pixels from a pointer to a needle, head or shaft. */
function farFrom(needle: Needle, camera: Camera, [x, y]: readonly [number, number]): number {
  const [ax, ay] = camera.project(needle.foot);
  const [bx, by] = camera.project(needle.head);
  const [ex, ey] = [bx - ax, by - ay];
  const part = Math.max(0, Math.min(1, ((x - ax) * ex + (y - ay) * ey) / Math.max(ex * ex + ey * ey, 1e-9)));
  const shaft = Math.hypot(x - ax - part * ex, y - ay - part * ey);
  return Math.min(Math.hypot(x - bx, y - by), shaft + 3); // a head wins over a shaft beside it
}

/** The places of the needles whose heads lie in a box of the canvas and can be seen. */
export function within(
  needles: readonly Needle[],
  camera: Camera,
  skin: HidingSkin,
  [left, top, right, bottom]: readonly [number, number, number, number],
): number[] {
  const inside = (needle: Needle): boolean => {
    const [x, y] = camera.project(needle.head);
    return x >= left && x <= right && y >= top && y <= bottom;
  };
  return needles.filter((needle) => inside(needle) && seen(needle, camera, skin)).map(({ place }) => place);
}

/** For each row the distance to the nearest other one, metres: where needles stand close their heads are small. */
export function spacing(rows: readonly number[], positions: Float32Array): number[] {
  const points = rows.map((row) => rowOf(positions, row));
  return points.map((point, place) => {
    let least = Infinity;
    points.forEach((other, at) => {
      if (at !== place) least = Math.min(least, size(minus(point, other)));
    });
    return least;
  });
}
