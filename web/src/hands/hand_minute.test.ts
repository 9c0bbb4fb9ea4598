import { expect, it } from "vitest";
import { GUIDE_SECONDS, guideTargets } from "./hand_guide";
import { HandMinute } from "./hand_minute";
import { seededNumbers, syntheticHand, syntheticPicture } from "./synthetic_hand";

/** Performs a minute; gone: between which seconds of it no hand is seen. */
function perform(gone: [number, number] = [0, 0]): { minute: HandMinute; took: number } {
  const minute = new HandMinute(100);
  let now = 100;
  for (; !minute.done && now < 300; now += 1 / 8) {
    const { time } = minute.state;
    const away = now > 100 + gone[0] && now < 100 + gone[1];
    const hands = away ? [] : [syntheticHand(guideTargets(Math.max(0, time - 0.2)))];
    minute.hear(syntheticPicture(now, ...hands), away ? -1 : 0);
  }
  return { minute, took: now - 100 };
}

it("gets ready, moves for its time, and gives a calibration", () => {
  expect(new HandMinute(0).state).toMatchObject({ phase: "ready", left: 3, share: 0 });
  const { minute, took } = perform();
  expect(took).toBeCloseTo(3 + GUIDE_SECONDS, 0);
  expect(minute.fit("Camera", 5)).toMatchObject({ camera: "Camera", made: 5, side: "right" });
});

it("takes a picture for the moment when it was taken, however long it was looked at", () => {
  const [minute, random] = [new HandMinute(0), seededNumbers(3)];
  for (let now = 0; !minute.done; now += 1 / 8) {
    minute.pass(now + 0.4 * random()); // the drawn hand has moved on meanwhile
    minute.hear(syntheticPicture(now, syntheticHand(guideTargets(Math.max(0, now - 3.2)))), 0);
  }
  const { delay, fit } = minute.fit("", 0);
  expect(delay).toBeCloseTo(0.2);
  expect(Math.min(...fit)).toBeGreaterThan(0.95);
});

it("waits while no hand is seen", () => {
  const { minute, took } = perform([20, 30]);
  expect(took).toBeCloseTo(3 + GUIDE_SECONDS + 10 - 0.5, 0);
  expect(Math.min(...minute.fit("", 0).fit)).toBeGreaterThan(0.9);
  const waiting = new HandMinute(0);
  waiting.hear(syntheticPicture(3.5, syntheticHand(guideTargets(0))), 0);
  waiting.hear(syntheticPicture(3.8), -1);
  waiting.pass(4.2);
  expect(waiting.state.phase).toBe("lost");
});

it("waits for no slow machine, but for one that has no pictures", () => {
  const minute = new HandMinute(0);
  for (let now = 0; now < 20; now += 0.7) minute.hear(syntheticPicture(now, syntheticHand(guideTargets(0))), 0);
  expect(minute.state.time).toBeCloseTo(19.6 - 3);
  minute.pass(21.7);
  expect(minute.state.phase).toBe("lost");
});
