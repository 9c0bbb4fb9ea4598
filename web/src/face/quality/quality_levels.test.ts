import { describe, expect, it } from "vitest";
import { LEVELS } from "../../link/constants";
import { definesOf, FEATURES, featuresOf, firstLevel, type Level, levelsOf, pixelRatio } from "./quality_levels";

describe("the levels", () => {
  it("cost more from one to the next, in no feature less", () => {
    for (const software of [false, true]) {
      const costs = LEVELS.map((level) => Object.values(featuresOf(level, software)).map(Number));
      costs.slice(1).forEach((cost, index) => {
        const before = costs[index] as number[];
        expect(cost.every((value, feature) => value >= (before[feature] as number))).toBe(true);
        expect(cost).not.toEqual(before);
      });
    }
  });

  it("start at the lowest where there is no graphics processor", () => {
    expect(firstLevel(true)).toBe(LEVELS[0]);
    expect(LEVELS.indexOf(firstLevel(false))).toBeGreaterThan(0);
  });

  it("differ without a graphics processor in what is dear there alone", () => {
    for (const level of LEVELS) {
      expect(featuresOf(level, false)).toEqual(FEATURES[level]);
      const { anisotropy, ...rest } = featuresOf(level, true);
      expect(anisotropy).toBe(1);
      if (level !== "medium" && level !== "good") expect(FEATURES[level]).toMatchObject(rest);
    }
    expect(featuresOf("medium", true)).toMatchObject({ ribbons: 1, multisample: false });
    expect(featuresOf("good", true)).toMatchObject({ ribbons: 1, multisample: true });
  });

  it("switch the shaders", () => {
    expect(definesOf(FEATURES.lowest)).toEqual({ FAST: "" });
    expect(definesOf(FEATURES.high)).toEqual({ SHADOW: "", DETAIL: "" });
    expect(definesOf(featuresOf("high", true))).toEqual({ SHADOW: "", DETAIL: "", SHARPEN: "" });
  });
});

describe("the pixels of a picture", () => {
  it("are the display's while they are few", () => {
    for (const level of LEVELS) expect(pixelRatio(FEATURES[level], 640, 360, 1)).toBe(1);
  });

  it("are never more than the level draws", () => {
    for (const level of LEVELS) {
      const ratio = pixelRatio(FEATURES[level], 3840, 2160, 2);
      expect(3840 * ratio * 2160 * ratio).toBeLessThanOrEqual(FEATURES[level].pixels * (1 + 1e-9));
    }
  });
});

const at = (level: Level): { fps: number; level: Level } => ({ fps: 60, level });

it("says nothing while no stage does", () => {
  expect(levelsOf([])).toBe("");
  expect(levelsOf([null])).toBe("");
});

it("names the level once when all draw at it", () => {
  expect(levelsOf([at("high"), null, at("high")])).toBe("high");
});

it("names the lowest and the highest of several", () => {
  expect(levelsOf([at("high"), at("lowest"), at("medium")])).toBe("lowest to high");
});
