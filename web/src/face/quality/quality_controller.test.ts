import { describe, expect, it } from "vitest";
import { LEVELS } from "../../link/constants";
import { type FrameReport, QualityController } from "./quality_controller";
import type { Level } from "./quality_levels";

/** Milliseconds that a machine needs for a picture at each level. */
type Machine = Readonly<Record<Level, number>>;
const STRONG: Machine = { lowest: 1, low: 1, medium: 2, good: 2, high: 3 };
const FAIR: Machine = { lowest: 2, low: 4, medium: 6, good: 7, high: 25 };
const WEAK: Machine = { lowest: 12, low: 30, medium: 60, good: 90, high: 120 };

/** What a display of `rate` Hz shows of a picture: the next refresh after it is done; every fifth is looked at. */
function report(machine: Machine, level: Level, frame: number, calm: boolean, rate = 60): FrameReport {
  const work = machine[level] / 1000;
  return { interval: Math.ceil(work * rate) / rate, early: frame % 5 === 0 ? work < 1 / 120 : undefined, calm };
}

/** Runs a chooser for some seconds; the levels it went through, and how long each took to be left. */
function run(qualityController: QualityController, machine: Machine, seconds: number, { calm = true, rate = 60 } = {}) {
  const path: Level[] = [qualityController.level];
  const changes: number[] = [];
  for (let time = 0, frame = 0; time < seconds; frame++) {
    const frameReport = report(machine, qualityController.level, frame, calm, rate);
    time += frameReport.interval;
    if (qualityController.after(frameReport) === path.at(-1)) continue;
    path.push(qualityController.level);
    changes.push(time);
  }
  return { path, changes };
}

describe("the level of quality", () => {
  it("goes down step by step until frames are in time, each within two seconds", () => {
    const { path, changes } = run(new QualityController("high"), WEAK, 60);
    expect(path).toEqual(["high", "good", "medium", "low", "lowest"]);
    changes.forEach((time, index) => {
      expect(time - (changes[index - 1] ?? 0)).toBeLessThan(2);
    });
  });

  it("goes up as far as there is head-room", () => {
    expect(run(new QualityController("lowest"), STRONG, 60).path).toEqual([...LEVELS]);
  });

  it("comes to rest: a level that proves too much is tried twice and left for good", () => {
    const qualityController = new QualityController("good");
    const { path, changes } = run(qualityController, FAIR, 600);
    expect(path).toEqual(["good", "high", "good", "high", "good"]);
    expect(changes.at(-1)).toBeLessThan(60);
  });

  it("is tried again for another size of picture", () => {
    const qualityController = new QualityController("good");
    run(qualityController, FAIR, 600);
    qualityController.forget();
    expect(run(qualityController, STRONG, 60).path).toEqual(["good", "high"]);
  });

  it("never goes up while something moves on air", () => {
    expect(run(new QualityController("lowest"), STRONG, 600, { calm: false }).path).toEqual(["lowest"]);
  });

  it("goes down on air only when frames stay late", () => {
    const { changes } = run(new QualityController("low"), WEAK, 60, { calm: false });
    expect(changes).toHaveLength(1);
    expect(changes[0]).toBeGreaterThan(2);
    expect(changes[0]).toBeLessThan(6);
  });

  it("is judged for seconds before anybody may draw less, and that once: also where nothing is fast enough", () => {
    const slow: Machine = { lowest: 40, low: 60, medium: 90, good: 120, high: 150 };
    for (const machine of [STRONG, FAIR, WEAK, slow]) {
      const qualityController = new QualityController("good");
      run(qualityController, machine, 2);
      expect(qualityController.proved).toBe(false);
      run(qualityController, machine, 60);
      for (let second = 0; second < 60; second++) {
        expect(qualityController.proved).toBe(true);
        run(qualityController, machine, 1, { calm: second % 2 === 0 });
      }
      qualityController.forget();
      expect(qualityController.proved).toBe(false);
    }
  });

  it("does not mind a slow display", () => {
    expect(run(new QualityController("good"), STRONG, 60, { rate: 30 }).path).toEqual(["good", "high"]);
  });

  it("stays where it is when nobody can look at the machine and frames are in time", () => {
    const qualityController = new QualityController("good");
    for (let frame = 0; frame < 6000; frame++)
      qualityController.after({ interval: 1 / 60, early: undefined, calm: true });
    expect(qualityController.level).toBe("good");
  });

  it("does not mind single late frames, nor a hidden page", () => {
    const qualityController = new QualityController("good");
    for (let frame = 0; frame < 6000; frame++) {
      const interval = frame % 50 === 0 ? 30 : frame % 7 === 0 ? 0.04 : 1 / 60;
      expect(qualityController.after({ interval, early: false, calm: true })).toBe("good");
    }
  });
});
