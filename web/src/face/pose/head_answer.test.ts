import { describe, expect, it } from "vitest";
import type { ExpressionDocument, FaceDocument } from "../../link/messages";
import { headOf } from "./head_answer";
import { mixPoses, restPose } from "./pose";

const face = (name: string, ...gains: FaceDocument["gains"]) => [name, { name, gains } as FaceDocument] as const;
const expression = (name: string, ...head: [number, number, number]) =>
  [name, { name, head } as ExpressionDocument] as const;
const CAST = {
  faces: new Map([
    face("kaori"),
    face("dog", { region: "head", value: 1.5, expression: null }, { region: "head", value: 0, expression: "fear" }),
  ]),
  expressions: new Map([
    expression("neutral", 0, 0, 0),
    expression("doubt", 0.1, 0, 0.2),
    expression("fear", 0, -0.1, 0),
  ]),
};

describe("the head", () => {
  it("of a person is where hands turn it, whatever it wears", () => {
    expect(headOf({ ...restPose("kaori", "doubt"), head: [0.1, 0.2, 0.3] }, CAST)).toEqual([0.1, 0.2, 0.3]);
  });

  it("of a face that answers with it is tilted by the expression, times the gain, beside what hands do", () => {
    const [yaw, pitch, roll] = headOf({ ...restPose("dog", "doubt"), head: [0.1, 0, 0] }, CAST);
    expect(yaw).toBeCloseTo(0.25);
    expect(pitch).toBe(0);
    expect(roll).toBeCloseTo(0.3);
    expect(headOf(restPose("dog", "fear"), CAST)).toEqual([0, 0, 0]);
  });

  it("adds channels, and passes over what is not in the cast", () => {
    expect(headOf({ ...restPose("dog"), channels: { doubt: 0.5, away: 1 } }, CAST)[2]).toBeCloseTo(0.15);
    expect(headOf({ ...restPose("gone", "doubt") }, CAST)).toEqual([0, 0, 0]);
  });

  it("goes with the ears, with the region that they are in", () => {
    const neutral = restPose("dog");
    for (const region of ["brows", "eyes", "mouth"] as const)
      expect(headOf({ ...neutral, regions: { [region]: { doubt: 1 } } }, CAST)).toEqual([0, 0, 0]);
    expect(headOf({ ...neutral, regions: { rest: { doubt: 1 } } }, CAST)[2]).toBeCloseTo(0.3);
  });

  it("goes evenly from one expression to another, and from one face to another", () => {
    for (const [from, to] of [
      [restPose("dog", "neutral"), restPose("dog", "doubt")],
      [restPose("kaori", "doubt"), restPose("dog", "doubt")],
    ] as const)
      for (const part of [0.25, 0.5, 1]) expect(headOf(mixPoses(from, to, part), CAST)[2]).toBeCloseTo(0.3 * part);
  });
});
