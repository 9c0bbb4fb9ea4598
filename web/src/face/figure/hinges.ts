/** How far elbows and knees are bent, and which correctives that calls, as `model.body.hinges` has it. */

import { BENDS, HINGES } from "../../link/constants";
import { cross, dot, length, minus, type Vector } from "./rotations";
import { placeOf, type Skeleton } from "./skeleton";

const KNOTS = [0, ...BENDS];

/** Writes how much of each corrective hinges call (hinges, bends), linear between bends; `joints`: where bones begin. */
export function writeCalls(skeleton: Skeleton, joints: readonly Vector[], into: Float32Array): void {
  into.fill(0);
  HINGES.forEach((names, hinge) => {
    const [begin, middle, end] = names.map((name) => joints[placeOf(skeleton, name)]) as [Vector, Vector, Vector];
    const [upper, lower] = [minus(middle, begin), minus(end, middle)];
    const degrees = (Math.atan2(length(cross(upper, lower)), dot(upper, lower)) * 180) / Math.PI;
    const next = KNOTS.findIndex((knot) => degrees < knot);
    const first = hinge * BENDS.length;
    if (next < 0) {
      into[first + BENDS.length - 1] = 1;
      return;
    }
    const [low, high] = [KNOTS[next - 1] as number, KNOTS[next] as number];
    const share = (degrees - low) / (high - low);
    into[first + next - 1] = share;
    if (next > 1) into[first + next - 2] = 1 - share;
  });
}
