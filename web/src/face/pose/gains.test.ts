import { describe, expect, it } from "vitest";
import { GAIN_REGIONS, type Gain, gainOf, mixGains, overrideGains, regionalGains } from "./gains";

const gain = (region: string, value: number, expression: string | null = null): Gain => ({ region, value, expression });
const DOG = [gain("brows", 1.6), gain("mouth", 1.2), gain("mouth", 2, "angry"), gain("ears", 1.5)];

describe("gains", () => {
  it("are neutral where a face sets none: ears and head still, all else as the field says", () => {
    const neutral = GAIN_REGIONS.map((region) => gainOf([], region, "joy"));
    expect(neutral).toEqual([1, 1, 1, 1, 1, 1, 0, 0]);
  });

  it("of one expression stand before those of all", () => {
    expect(gainOf(DOG, "mouth", "angry")).toBe(2);
    expect(gainOf(DOG, "mouth", "joy")).toBe(1.2);
    expect(gainOf(DOG, "mouth")).toBe(1.2);
  });

  it("of a mix are the weighted mean, for every expression", () => {
    const mixed = mixGains([
      [DOG, 0.25],
      [[gain("ears", 3)], 0.75],
    ]);
    for (const region of GAIN_REGIONS)
      for (const name of [null, "angry", "joy"]) {
        const wanted = 0.25 * gainOf(DOG, region, name) + 0.75 * (region === "ears" ? 3 : gainOf([], region, name));
        expect(gainOf(mixed, region, name)).toBeCloseTo(wanted, 9);
      }
    expect(mixGains([[[], 1]])).toEqual([]);
  });

  it("come with a region from another face, and own ones stand before all", () => {
    expect(regionalGains(DOG, { mouth: [gain("mouth", 3), gain("ears", 4)] })).toEqual([
      gain("brows", 1.6),
      gain("mouth", 3),
      gain("ears", 1.5),
    ]);
    expect(overrideGains(DOG, [gain("ears", 0), gain("brows", 2)])).toEqual([
      gain("brows", 2),
      gain("mouth", 1.2),
      gain("mouth", 2, "angry"),
    ]);
  });
});
