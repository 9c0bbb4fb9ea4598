import { describe, expect, it } from "vitest";
import type { ExpressionDocument } from "../../link/messages";
import { complexionOf } from "./complexion";
import { mixPoses, poseKey, restPose } from "./pose";

const expression = (name: string, ...complexion: ExpressionDocument["complexion"]) =>
  [name, { name, complexion } as ExpressionDocument] as const;
const CAST = new Map([expression("cry", 0.5, 1, 0.25, 1, 0, 1, 0), expression("fear", -0.5, 0, 0, 0, -0.5, 0, 0.5)]);

describe("the complexion of a pose", () => {
  it("is what the show says", () => {
    const pose = { ...restPose("kaori", "cry"), complexion: [0, 0.5, 0, 0, 0, 0.25, 0.75, 0.125] };
    expect(complexionOf(pose, CAST)).toEqual({
      cheeks: 0,
      nose: 0.5,
      forehead: 0,
      eyes: 0,
      whole: 0,
      tears: 0.25,
      sweat: 0.75,
      drops: 0.125,
    });
    expect(complexionOf({ ...pose, complexion: [] }, CAST).nose).toBe(0);
  });

  it("is what expressions and channels bring where it says nothing, each in its region, within what skin can do", () => {
    const pose = { ...restPose("kaori", "fear"), channels: { cry: 2 }, regions: { brows: { cry: 1 } } };
    expect(complexionOf(pose, CAST)).toEqual({
      cheeks: 0.5,
      nose: 1.4,
      forehead: 0.75,
      eyes: 1.4,
      whole: -0.5,
      tears: 1,
      sweat: 0.5,
      drops: 0,
    });
  });

  it("goes evenly from one state to the next, and is a part of what a pose shows", () => {
    const [from, to] = [[], [1, 0, 0, 0, 0, 0.5, 1, 2]].map((complexion) => ({ ...restPose("kaori"), complexion }));
    const half = mixPoses(from as typeof to & object, to as typeof to & object, 0.5);
    expect(half.complexion).toEqual([0.5, 0, 0, 0, 0, 0.25, 0.5, 1]);
    expect(poseKey(half)).not.toBe(poseKey(restPose("kaori")));
  });
});
