import { expect, it } from "vitest";
import {
  adviseOnCalibration,
  fitHand,
  type HandSample,
  handSample,
  readCalibration,
  readHand,
  sayDelay,
} from "./hand_calibration";
import { GUIDE_SECONDS, guideTargets, HAND_AXES, type HandAxes } from "./hand_guide";
import { correlation } from "./ridge";
import { STILL, seededNumbers, syntheticHand } from "./synthetic_hand";

/** A performer who follows the drawn hand so many seconds late, as a model sees them: points that shake. */
function perform(delay: number, rate = 8, noise = 0.002): HandSample[] {
  const random = seededNumbers(5);
  const samples: HandSample[] = [];
  for (let time = 0; time < GUIDE_SECONDS; time += 1 / rate) {
    const hand = syntheticHand(guideTargets(Math.max(0, time - delay)), { side: random() < 0.1 ? "left" : "right" });
    for (const points of [hand.image, hand.world])
      points.forEach((value, place) => {
        points[place] = value + noise * (random() - 0.5);
      });
    const sample = handSample(hand, 640, 480, time);
    if (sample !== null) samples.push(sample);
  }
  return samples;
}

const calibration = fitHand(perform(0.24), 20, "Camera A", 1e12);

it("finds the performer's own delay, side and place", () => {
  expect(calibration.delay).toBeCloseTo(0.24, 1);
  for (const delay of [0.1, 0.4]) expect(fitHand(perform(delay), 20, "", 0).delay).toBeCloseTo(delay, 1);
  expect(calibration).toMatchObject({ side: "right", camera: "Camera A", made: 1e12 });
  expect(calibration.place[0]).toBeCloseTo(0.4, 1);
  expect(Math.min(...calibration.fit)).toBeGreaterThan(0.9);
});

it("reads what a hand does that moves otherwise than in the minute", () => {
  const random = seededNumbers(6);
  const [done, read]: [number[][], number[][]] = [[], []];
  for (let count = 0; count < 300; count++) {
    const axes = Object.fromEntries(
      HAND_AXES.map((axis) => [axis, axis === "opening" ? random() : 1.4 * (random() - 0.5)]),
    ) as HandAxes;
    const sample = handSample(syntheticHand(axes), 640, 480, 0);
    if (sample === null) continue;
    done.push(HAND_AXES.map((axis) => axes[axis]));
    read.push(readHand(calibration, sample));
  }
  HAND_AXES.forEach((axis, place) => {
    const [truth, found] = [done, read].map((rows) => rows.map((row) => row[place] ?? 0));
    expect([axis, correlation(truth ?? [], found ?? []) > 0.9]).toEqual([axis, true]);
  });
});

it("never reads beyond the ends of an axis", () => {
  for (const opening of [-3, 3]) {
    const sample = handSample(syntheticHand({ ...STILL, opening, index: 5 }), 640, 480, 0);
    for (const value of sample ? readHand(calibration, sample) : []) expect(Math.abs(value)).toBeLessThanOrEqual(1);
  }
});

it("refuses a minute in which the hand was hardly seen, and says what to do", () => {
  expect(() => fitHand([], 20, "", 0)).toThrow("More light");
  expect(() =>
    fitHand(
      perform(0.2).filter(({ time }) => time > 10),
      20,
      "",
      0,
    ),
  ).toThrow("at the beginning");
});

it("keeps a calibration as text, and takes no other text for one", () => {
  const text = JSON.stringify(calibration);
  expect(readCalibration(text)).toEqual(calibration);
  for (const wrong of [
    null,
    "",
    "{}",
    "[1]",
    text.replace('"version":2', '"version":1'),
    text.replace('"delay":', '"x":'),
    text.replace('"palms":[[', '"palms":[[1,'),
  ])
    expect(readCalibration(wrong)).toBeNull();
});

it("says when a calibration is old, of another camera, or was not followed", () => {
  const day = 86_400_000;
  expect(adviseOnCalibration(calibration, "Camera A", 1e12 + day)).toBe("");
  expect(adviseOnCalibration(calibration, "Camera A", 1e12 + 8 * day)).toContain("8 days old");
  expect(adviseOnCalibration(calibration, "Camera B", 1e12)).toContain("another camera (Camera A)");
  expect(adviseOnCalibration({ ...calibration, fit: [0.5, 1, 1, 1, 1, 1] }, "", 1e12)).toContain("in profile");
});

it("says that pictures were too few, where they were, and nothing of the hand", () => {
  const bad = { ...calibration, fit: [0.5, 1, 1, 1, 1, 1] };
  const few = adviseOnCalibration({ ...bad, rate: 6.4 }, "", 1e12);
  expect(few).toContain("6 pictures a second");
  expect(few).toMatch(/close/i);
  expect(few).not.toContain("profile");
  expect(adviseOnCalibration({ ...calibration, rate: 6.4 }, "", 1e12)).toBe(""); // it was followed all the same
});

it("knows a delay only where the opening was followed", () => {
  expect(sayDelay(calibration)).toContain("240 ms behind");
  expect(sayDelay({ ...calibration, fit: [0.5, 1, 1, 1, 1, 1], delay: 0 })).toBe("");
});
