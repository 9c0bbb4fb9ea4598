import { describe, expect, it } from "vitest";
import { mixScalp, stubbleAt } from "./scalp";

const kaori = { scalp: 1 };
const old = { scalp: 0.4 };
const baby = { scalp: 0.35 };
const dog = { scalp: 0 };

describe("the scalp", () => {
  it("is each face's own", () => {
    for (const face of [kaori, old, baby, dog]) expect(mixScalp([{ ...face, weight: 1 }])).toBeCloseTo(face.scalp);
    expect(mixScalp([])).toBe(0);
  });

  it("lies between its faces and is never lighter for more of the darker one", () => {
    const painted = Array.from({ length: 51 }, (_, step) =>
      mixScalp([
        { ...kaori, weight: step / 100 },
        { ...baby, weight: 0.5 },
        { ...dog, weight: 0.5 - step / 100 },
      ]),
    );
    for (const [step, value] of painted.entries()) {
      expect(value).toBeGreaterThanOrEqual(painted[step - 1] ?? 0);
      expect(value).toBeLessThanOrEqual(1);
    }
  });

  it("is as dark half way to a balding head as under the full head of hair", () => {
    const halves = [
      { ...kaori, weight: 0.5 },
      { ...old, weight: 0.5 },
    ];
    expect(mixScalp(halves)).toBeCloseTo(1);
    expect(mixScalp(halves.reverse())).toBeCloseTo(1);
  });

  it("is covered with stubble before half of a face has hair, without a jump", () => {
    const painted = Array.from({ length: 101 }, (_, step) =>
      mixScalp([
        { ...kaori, weight: step / 100 },
        { ...dog, weight: 1 - step / 100 },
      ]),
    );
    expect(painted[0]).toBe(0);
    expect(painted[50]).toBe(1);
    for (const [step, value] of painted.entries()) {
      expect(value).toBeCloseTo(stubbleAt(step / 100));
      expect(Math.abs(value - (painted[step - 1] ?? 0))).toBeLessThan(0.06);
    }
  });
});
