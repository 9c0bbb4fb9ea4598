/** The body of a performer whom a source sees, part of the way from one state to another. */

import type { TrackedState } from "../../link/messages";

/** Steps of its numbers, of which a turn of 3.5 radians has 32767: one that goes on beyond half a turn comes back from the
 * other side, and is not swept through the front between two states. */
const HALF_TURN = (Math.PI * 32767) / 3.5;

/** Its numbers. */
export const numbersOf = ({ pose }: TrackedState): DataView =>
  new DataView(pose.buffer, pose.byteOffset, pose.byteLength);

/** The body part of the way (0..1) from one to the other; what is not seen shows nothing of it. */
export function mixTracked(
  from: TrackedState | undefined,
  to: TrackedState | undefined,
  part: number,
): TrackedState | undefined {
  const shown = to ?? from;
  if (shown === undefined) return undefined;
  const shares = shown.shares.map((_, at) => {
    const before = from?.shares[at] ?? 0;
    return before + part * ((to?.shares[at] ?? 0) - before);
  });
  if (from === undefined || to === undefined || from.pose.length !== to.pose.length)
    return { shares, pose: shown.pose };
  const pose = new Uint8Array(to.pose.length);
  const [first, second, into] = [numbersOf(from), numbersOf(to), new DataView(pose.buffer)];
  for (let at = 0; at < pose.length; at += 2) {
    const [before, after] = [first.getInt16(at, true), second.getInt16(at, true)];
    const way = Math.abs(after - before) > HALF_TURN ? after : Math.round(before + part * (after - before));
    into.setInt16(at, way, true);
  }
  return { shares, pose };
}

/** The same text for the same body. */
export const trackedKey = (tracked: TrackedState | undefined): string =>
  tracked === undefined ? "" : `${tracked.shares.join()} ${tracked.pose.join()}`;
