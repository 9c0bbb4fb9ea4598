/** The named points of a photograph that people drag; what lies around one moves with it, the other handles stay. */

/** What people call the handles, and their rows among the model's points; left is the person's own. */
export const HANDLES = [
  ["Forehead", 10],
  ["Right brow", 105],
  ["Left brow", 334],
  ["Right eye, outer corner", 33],
  ["Right eye, inner corner", 133],
  ["Left eye, inner corner", 362],
  ["Left eye, outer corner", 263],
  ["Tip of the nose", 4],
  ["Right corner of the mouth", 61],
  ["Left corner of the mouth", 291],
  ["Chin", 152],
  ["Outline at the right ear", 234],
  ["Outline at the left ear", 454],
  ["Right angle of the jaw", 172],
  ["Left angle of the jaw", 397],
] as const;

/** The points (n, 3) after a handle, one of `HANDLES` by its place, was moved by parts of the picture; shape: its
 * width over its height. */
export function moveHandle(points: Float32Array, handle: number, [dx, dy]: readonly [number, number], shape: number) {
  const row = rowOf(handle);
  const away = (point: number, other: number): number =>
    Math.hypot(
      ((points[3 * point] as number) - (points[3 * other] as number)) * shape,
      (points[3 * point + 1] as number) - (points[3 * other + 1] as number),
    );
  const others = HANDLES.map((_, at) => rowOf(at)).filter((other) => other !== row);
  const reach = Math.max(1e-6, Math.min(...others.map((other) => away(row, other))));
  const moved = points.slice();
  for (let point = 0; 3 * point < points.length; point++) {
    const share = Math.max(0, 1 - (away(row, point) / reach) ** 2) ** 2;
    moved[3 * point] = (points[3 * point] as number) + share * dx;
    moved[3 * point + 1] = (points[3 * point + 1] as number) + share * dy;
  }
  return moved;
}

/** The row of a handle among the points. */
export const rowOf = (handle: number): number => (HANDLES[handle] as (typeof HANDLES)[number])[1];
