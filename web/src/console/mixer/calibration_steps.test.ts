import { expect, test } from "vitest";
import { CALIBRATION_STEPS, channelsOf, stepsFor } from "./calibration_steps";

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
