import { expect, it } from "vitest";
import { fitHand, type HandSample, handSample } from "./hand_calibration";
import { GUIDE_SECONDS, guideTargets } from "./hand_guide";
import { adviseOnAbsence, HandTracker } from "./hand_tracker";
import { STILL, syntheticHand, syntheticPicture } from "./synthetic_hand";

const samples: HandSample[] = [];
for (let time = 0; time < GUIDE_SECONDS; time += 0.1) {
  const sample = handSample(syntheticHand(guideTargets(time)), 640, 480, time);
  if (sample !== null) samples.push(sample);
}
const calibration = fitHand(samples, 20, "", 0);

it("plays the calibrated side at first, then follows by place, whatever the labels say", () => {
  const tracker = new HandTracker(calibration);
  const playing = syntheticHand({ ...STILL, opening: 1 }, { x: 0.3, side: "right" });
  const other = syntheticHand(STILL, { x: 0.8, side: "left" });
  expect(tracker.read(syntheticPicture(0, other, playing)).playing).toBe(1);
  for (let count = 1; count < 20; count++) {
    const sides = count % 2 ? (["left", "right"] as const) : (["left", "left"] as const);
    const moved = syntheticHand({ ...STILL, opening: 1 }, { x: 0.3 + 0.02 * count, side: sides[0] });
    const { playing: place, axes } = tracker.read(syntheticPicture(count / 15, { ...other, side: sides[1] }, moved));
    expect(place).toBe(1);
    if (count > 10) expect(axes?.opening).toBeGreaterThan(0.85);
  }
});

it("takes no other hand for one that has gone, and the same one where it comes back", () => {
  const tracker = new HandTracker(calibration);
  const [playing, other] = [syntheticHand(STILL, { x: 0.2 }), syntheticHand(STILL, { x: 0.7, side: "left" })];
  tracker.read(syntheticPicture(0, playing, other));
  expect(tracker.read(syntheticPicture(0.1, other)).playing).toBe(-1);
  expect(tracker.read(syntheticPicture(0.2, other, playing)).playing).toBe(1);
  expect(tracker.read(syntheticPicture(5)).axes).toBeNull();
  expect(tracker.read(syntheticPicture(6, syntheticHand(STILL, { x: 0.9, side: "left" }))).playing).toBe(0);
});

it("says that the hand is turned when that lasts, not when it plays", () => {
  const tracker = new HandTracker(calibration);
  let time = 0;
  const play = (seconds: number, yaw: (time: number) => number): boolean => {
    let turned = false;
    for (const end = time + seconds; time < end; time += 0.05) {
      turned = tracker.read(syntheticPicture(time, syntheticHand({ ...STILL, yaw: yaw(time) }))).turned;
    }
    return turned;
  };
  expect(play(10, (now) => 0.9 * Math.sin(4 * now))).toBe(false);
  expect(play(15, () => 1.3)).toBe(true);
  expect(play(20, () => 0)).toBe(false);
});

it("makes a point of the other hand, as in a mirror", () => {
  const tracker = new HandTracker(calibration);
  const read = (x: number, y: number) =>
    tracker.read(syntheticPicture(0, syntheticHand(STILL, { x: 0.4 }), syntheticHand(STILL, { x, y, side: "left" })));
  expect(read(0.9, 0.5).other).toEqual([expect.closeTo(-1), expect.closeTo(0)]);
  expect(new HandTracker(calibration).read(syntheticPicture(0, syntheticHand(STILL))).other).toBeNull();
});

it("reads nothing of a hand that is not calibrated", () => {
  expect(new HandTracker(null).read(syntheticPicture(0, syntheticHand(STILL)))).toMatchObject({
    playing: 0,
    axes: null,
  });
});

it("counts from the first picture, or the last with the hand, how long it is away, says then what to do, and where it points", () => {
  const tracker = new HandTracker(null);
  const away = (time: number, ...hands: Parameters<typeof syntheticPicture>[1][]): number =>
    tracker.read(syntheticPicture(time, ...hands)).away;
  expect([away(10), away(14), away(15, syntheticHand(STILL)), away(17)]).toEqual([0, 4, 0, 2]);
  const [there, gone] = [syntheticPicture(18, syntheticHand(STILL)), syntheticPicture(19)];
  expect([there, gone].map((hands) => tracker.read(hands).leftward)).toEqual([true, null]);
  expect([0, 2, 4].map((seconds) => adviseOnAbsence(seconds) !== "")).toEqual([false, false, true]);
});
