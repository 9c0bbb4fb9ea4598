/** The head's direction with what expressions add to it on faces that answer with their heads. */

import type { ExpressionDocument, FaceDocument } from "../../link/messages";
import { gainOf } from "./gains";
import { expressionWeights } from "./mix_terms";
import type { Pose } from "./pose";

/** Documents by source. */
export interface Documents {
  faces: ReadonlyMap<string, FaceDocument>;
  expressions: ReadonlyMap<string, ExpressionDocument>;
}

/** Yaw, pitch and roll (radians): those of the pose, and by weight what each face makes of each expression's own; a head
 * goes with its ears, with the region `rest`. */
export function headOf(pose: Pose, { faces, expressions }: Documents): Pose["head"] {
  const [yaw, pitch, roll] = pose.head;
  const total: Pose["head"] = [yaw, pitch, roll];
  for (const [name, share] of Object.entries(pose.faces)) {
    const gains = faces.get(name)?.gains ?? [];
    if (!gains.some(({ region }) => region === "head")) continue;
    for (const [source, weight] of Object.entries(expressionWeights(pose, "rest"))) {
      const turn = expressions.get(source)?.head ?? [0, 0, 0];
      const gain = share * weight * gainOf(gains, "head", source);
      turn.forEach((angle, axis) => {
        total[axis] = (total[axis] as number) + gain * angle;
      });
    }
  }
  return total;
}
