import { describe, expect, it } from "vitest";
import { FrameRate } from "./frame_rate";

function ticked(times: readonly number[]): FrameRate {
  const rate = new FrameRate();
  for (const time of times) rate.tick(time);
  return rate;
}

describe("the rate of frames", () => {
  it("counts those of the last second", () => {
    const times = Array.from({ length: 200 }, (_, at) => at / 50);
    expect(ticked(times).at(times.at(-1) as number)).toBe(50);
  });

  it("is a part of one where frames take longer than a second", () => {
    expect(ticked([0, 4]).at(4)).toBe(0.25);
  });

  it("knows the interval of the last frames, and none before two", () => {
    const even = Array.from({ length: 300 }, (_, at) => at / 60);
    expect(ticked([...even, 5.2, 5.4, 5.6, 5.8, 6]).interval).toBeCloseTo(0.2, 1);
    expect([ticked([]).interval, ticked([7]).interval]).toEqual([0, 0]);
  });

  it("falls while no frame comes", () => {
    expect(ticked([0, 0.5, 1]).at(11)).toBe(0.1);
  });
});
