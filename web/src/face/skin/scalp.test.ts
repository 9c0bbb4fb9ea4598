import { describe, expect, it } from "vitest";
import { mixScalp, stubbleAt } from "./scalp";

const kaori = { haired: true, scalp: 1 };
const old = { haired: true, scalp: 0.4 };
const baby = { haired: false, scalp: 0.35 };
const dog = { haired: false, scalp: 0 };

describe("the scalp", () => {
  it("is each face's own", () => {
    for (const face of [kaori, old, baby, dog]) expect(mixScalp([{ ...face, weight: 1 }])).toBeCloseTo(face.scalp);
    expect(mixScalp([])).toBe(0);
  });

  it("is the mean of those who wear hair, and of those who do not", () => {
    for (const [one, two] of [
      [kaori, old],
      [baby, dog],
    ] as const) {
      const mixed = mixScalp([
        { ...one, weight: 0.25 },
        { ...two, weight: 0.75 },
      ]);
      expect(mixed).toBeCloseTo(0.25 * one.scalp + 0.75 * two.scalp);
    }
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
