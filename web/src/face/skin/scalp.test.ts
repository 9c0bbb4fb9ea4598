import { Color } from "three";
import { describe, expect, it } from "vitest";
import { type HairLook, mixHairColour, mixScalp, stubbleAt } from "./scalp";

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
      expect(Math.abs(value - (painted[step - 1] ?? 0))).toBeLessThan(0.08);
    }
  });
});

describe("the colour of hair", () => {
  const black: HairLook = { hair: "#000000", hair_style: "bob", skin: "#ffffff", brow: "#000000", fur: 0, lacquer: 0 };
  const bald: HairLook = { ...black, hair: "#ff0000", hair_style: "" };
  const mix = (looks: readonly (readonly [HairLook, number])[]): number[] => {
    const into = new Color(9, 9, 9);
    mixHairColour(looks, into);
    return into.toArray();
  };

  it("is the mean of those who wear it, in roots of light", () => {
    const white = { ...black, hair: "#ffffff" };
    expect(mix([[black, 1]])).toEqual([0, 0, 0]);
    expect(
      mix([
        [black, 0.75],
        [white, 0.25],
      ]),
    ).toEqual([0.0625, 0.0625, 0.0625]);
  });

  it("passes into the fur of an animal, and into the paint of a mask", () => {
    expect(
      mix([
        [black, 0.5],
        [{ ...bald, fur: 1 }, 0.5],
      ]),
    ).toEqual([0.25, 0.25, 0.25]);
    expect(
      mix([
        [black, 0.5],
        [{ ...bald, lacquer: 1 }, 0.5],
      ]),
    ).toEqual([0, 0, 0]);
  });

  it("of heads that are all bald is what they would wear, whatever was shown before", () => {
    expect(mix([[bald, 1]])).toEqual([1, 0, 0]);
  });
});
