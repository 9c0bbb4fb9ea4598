import { describe, expect, it } from "vitest";
import type { ExpressionDocument, FaceDocument } from "../../link/messages";
import { mixPoses, type Pose, restPose } from "../pose/pose";
import { type EyeTraits, eyeTraitsOf, writeEyeTraits } from "./eye_traits";

const face = (name: string, iris_size: number, slit: number, lashes: number) =>
  ({ name, look: { iris_size, slit, lashes } }) as FaceDocument;
const expression = (name: string, pupil: number) => ({ name, pupil }) as ExpressionDocument;
const byName = <T extends { name: string }>(...documents: T[]) =>
  new Map(documents.map((document) => [document.name, document]));
const CAST = {
  faces: byName(face("kaori", 1, 0, 0.9), face("cat", 1.5, 1, 0.1)),
  expressions: byName(expression("fear", 1), expression("angry", -0.5), expression("pupils-narrow", -1)),
};
const of = (pose: Pose) => eyeTraitsOf(pose, CAST);

describe("traits", () => {
  it("are those of the face on air", () => {
    expect(of(restPose("cat"))).toEqual({ irisSize: 1.5, slit: 1, lashes: 0.1, pupil: 0 });
  });

  it("are linear from one pose to another, so that nothing pops", () => {
    const [from, to] = [restPose("kaori", "fear"), { ...restPose("cat", "angry"), channels: { "pupils-narrow": 0.5 } }];
    const [first, last] = [of(from), of(to)];
    for (const part of [0.1, 0.5, 0.8]) {
      const mixed = of(mixPoses(from, to, part));
      for (const name of Object.keys(first) as (keyof EyeTraits)[])
        expect(mixed[name]).toBeCloseTo(first[name] * (1 - part) + last[name] * part);
    }
  });

  it("add up expressions, channels and what is added without a limit", () => {
    const pose = { ...restPose("kaori", "fear"), channels: { fear: 1 }, added: { angry: 1 } };
    expect(of(pose).pupil).toBeCloseTo(1.5);
  });

  it("have the pupils of what shows around the eyes", () => {
    for (const region of ["brows", "mouth", "rest"] as const)
      expect(of({ ...restPose("kaori", "fear"), regions: { [region]: { angry: 1 } } }).pupil).toBe(1);
    expect(of({ ...restPose("kaori", "fear"), regions: { eyes: { angry: 1 } } }).pupil).toBe(-0.5);
  });

  it("are written where the shaders read them", () => {
    const uniforms = { irisSize: { value: 0 }, slit: { value: 0 }, lashes: { value: 0 }, pupil: { value: 9 } };
    writeEyeTraits(of(restPose("cat")), uniforms);
    expect(uniforms).toEqual({
      irisSize: { value: 1.5 },
      slit: { value: 1 },
      lashes: { value: 0.1 },
      pupil: { value: 0 },
    });
  });

  it("pass over names that are not in the cast", () => {
    expect(of({ ...restPose("kaori", "gone"), channels: { away: 1 } }).pupil).toBe(0);
  });
});
