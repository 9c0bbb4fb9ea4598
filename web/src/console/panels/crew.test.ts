import { expect, it } from "vitest";
import type { StageReport } from "../../link/messages";
import { levelsOf } from "./crew";

const at = (level: StageReport["level"]): StageReport => ({ fps: 60, level });

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
