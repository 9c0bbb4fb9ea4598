import { describe, expect, it } from "vitest";
import { mixPoses, type Pose, restPose } from "./pose";
import { type Due, Timeline } from "./timeline";

const state = (time: number, old: number, epoch = 1): Pose & Due => ({
  ...restPose("generic"),
  faces: { generic: 1 - old, old },
  head: [old, 0, 0],
  time,
  epoch,
});

const filled = (): Timeline<Pose> => {
  const timeline = new Timeline(mixPoses);
  for (let n = 0; n <= 6; n++) timeline.push(state(100 + n / 60, n / 6), n / 60);
  return timeline;
};

describe("a timeline", () => {
  it("shows nothing before the first state", () => {
    expect(new Timeline(mixPoses).at(1, 1)).toBeUndefined();
  });

  it("lies on the straight line between the states on either side", () => {
    const timeline = filled();
    for (const part of [0, 0.1, 0.35, 0.5, 0.99]) {
      const pose = timeline.at(100 + part / 10, 0.1);
      expect(pose?.faces.old).toBeCloseTo(part, 9);
      expect(pose?.head[0]).toBeCloseTo(part, 9);
      expect((pose?.faces.old ?? 0) + (pose?.faces.generic ?? 0)).toBeCloseTo(1, 12);
    }
  });

  it("holds the newest state past its end: nothing is extrapolated", () => {
    const timeline = filled();
    expect(timeline.at(100.1, 0.1)?.faces).toEqual({ generic: 0, old: 1 });
    expect(timeline.at(900, 800)?.faces).toEqual({ generic: 0, old: 1 });
  });

  it("waits at its first state for the time to come", () => {
    expect(filled().at(50, 0)?.faces).toEqual({ generic: 1, old: 0 });
  });

  it.each([
    ["a gap", 104, 1],
    ["a restarted server", 3, 2],
  ])("eases from what it showed after %s", (_, time, epoch) => {
    const timeline = filled();
    timeline.at(100.1, 0.1);
    timeline.push(state(time, 0, epoch), 4);
    const shown: number[] = [];
    for (let local = 4; local < 4.6; local += 1 / 120) shown.push(timeline.at(time, local)?.faces.old ?? Number.NaN);
    expect(shown[0]).toBeCloseTo(1, 6);
    expect(shown.at(-1)).toBe(0);
    for (let n = 1; n < shown.length; n++) {
      const step = (shown[n - 1] as number) - (shown[n] as number);
      expect(step).toBeGreaterThanOrEqual(0);
      expect(step).toBeLessThan(0.04);
    }
  });

  it("says how long it has heard nothing", () => {
    expect(filled().silence(2.1)).toBeCloseTo(2, 9);
  });
});
