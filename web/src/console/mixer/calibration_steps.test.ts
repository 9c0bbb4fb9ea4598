import { expect, test } from "vitest";
import { adviceOnRest, CALIBRATION_STEPS, channelsOf, stepsFor } from "./calibration_steps";

test("a source is asked for rest and for what it has channels of", () => {
  const steps = stepsFor(["jawOpen", "eyeBlinkLeft", "eyeBlinkRight"]);
  expect(steps.map(({ label }) => label)).toEqual(["At rest", "Eyes shut", "Mouth open"]);
});

test("a step measures its channels on both sides, and no channel is measured twice", () => {
  const [, shut] = CALIBRATION_STEPS;
  expect(shut && channelsOf(shut, ["eyeBlinkLeft", "jawOpen", "eyeBlinkRight"])).toEqual([
    "eyeBlinkLeft",
    "eyeBlinkRight",
  ]);
  const starts = CALIBRATION_STEPS.flatMap(({ of }) => of);
  expect(new Set(starts).size).toBe(starts.length);
});

test("a rest that smiles, or has the mouth open or the eyes shut, is said to be none", () => {
  expect(adviceOnRest({})).toBe("");
  expect(adviceOnRest({ mouthSmileLeft: 0.2, jawOpen: 0.1, eyeBlinkLeft: 0.3, mouthPucker: 0.3 })).toBe("");
  expect(adviceOnRest({ mouthSmileLeft: 0.2, mouthSmileRight: 0.6 })).toContain("has a smile;");
  expect(adviceOnRest({ jawOpen: 0.4, eyeBlinkRight: 0.8 })).toContain("has the mouth open and the eyes shut;");
});
