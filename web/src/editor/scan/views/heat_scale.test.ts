import { describe, expect, it } from "vitest";
import { HEAT_STOPS, heatGradient, heatOf, UNSEEN } from "./heat_scale";

describe("the colours of distances", () => {
  it("meet the legend at each of its stops, and lie between them elsewhere", () => {
    for (const [at, [stop, colour]] of HEAT_STOPS.entries()) {
      expect(heatOf(stop)).toEqual([...colour]);
      const next = HEAT_STOPS[at + 1];
      if (next === undefined) continue;
      const middle = heatOf((stop + next[0]) / 2);
      middle.forEach((part, place) => {
        expect(part).toBeCloseTo(((colour[place] as number) + (next[1][place] as number)) / 2, 9);
      });
    }
  });

  it("stay at the last beyond it, and are none of them where nothing was seen", () => {
    expect(heatOf(50)).toEqual(heatOf(HEAT_STOPS.at(-1)?.[0] ?? 0));
    expect(heatOf(Number.NaN)).toEqual(UNSEEN);
    expect(HEAT_STOPS.map(([, colour]) => colour)).not.toContainEqual(UNSEEN);
  });

  it("are the background of the legend", () => {
    expect(heatGradient().match(/rgb/g)).toHaveLength(HEAT_STOPS.length);
  });
});
