import { describe, expect, it } from "vitest";
import { MOST_KNOTS } from "../../link/constants";
import {
  drawnRange,
  freeName,
  isTwoWay,
  mirrored,
  movedKnot,
  newTarget,
  reading,
  targetAt,
  targetChoices,
  targetLabel,
  withKnotAt,
  withoutKnot,
  wrongName,
} from "./macro_targets";
import { curveAt, type Knots, STRAIGHT } from "./monotone_curve";

const BENT: Knots = [
  [0, 0],
  [0.4, 0.9],
  [1, 1],
];

describe("targets of a macro", () => {
  it("keeps knots in their order, within the way, and both ends where they are", () => {
    expect(movedKnot(BENT, 1, [2, -1])).toEqual([
      [0, 0],
      [0.99, 0],
      [1, 1],
    ]);
    expect(movedKnot(BENT, 1, [-1, 2])[1]).toEqual([0.01, 1]);
    expect(movedKnot(BENT, 0, [0.5, 0.5])).toBe(BENT);
    expect(movedKnot(BENT, 2, [0.5, 0.3])[2]).toEqual([1, 0.3]);
  });

  it("adds a knot on the curve, and takes it away again", () => {
    const more = withKnotAt(BENT);
    expect(more[2]?.[0]).toBeCloseTo(0.7, 9);
    expect(more[2]?.[1]).toBeCloseTo(curveAt(BENT, 0.7), 4);
    expect(withoutKnot(more, 2)).toEqual(BENT);
    expect(withoutKnot(BENT, 0)).toBe(BENT);
    expect(withoutKnot(BENT, 2)).toBe(BENT);
  });

  it("has no room for more knots than there may be, and none for two at one place", () => {
    let knots = STRAIGHT;
    for (let count = 0; count < 10; count += 1) knots = withKnotAt(knots);
    expect(knots).toHaveLength(MOST_KNOTS);
    expect(withKnotAt(BENT, 0.4)).toBe(BENT);
  });

  it("mirrors what it gives, and mirrored twice it is as before", () => {
    const turn = { ...newTarget("head/yaw"), curve: BENT.map((knot): [number, number] => [...knot]) };
    for (const macro of [-1, -0.3, 0, 0.6])
      expect(targetAt(mirrored(turn), macro)).toBeCloseTo(targetAt(turn, -macro), 12);
    expect(mirrored(mirrored(turn))).toEqual(turn);
    const jaw = newTarget("channel/jawOpen");
    expect([targetAt(mirrored(jaw), 0), targetAt(mirrored(jaw), 1)]).toEqual([1, 0]);
  });

  it("draws between the ends of both halves, in units that people read", () => {
    const turn = newTarget("head/yaw");
    expect(drawnRange(turn)).toEqual({ low: -0.4, high: 0.4 });
    expect(isTwoWay({ targets: [turn] })).toBe(true);
    expect(reading("head/yaw", 0.4)).toBe("23°");
    expect(reading("channel/jawOpen", 0.5)).toBe("50%");
    expect(targetLabel("pad/mouth/x", String)).toBe("Pad mouth, x");
    expect(targetChoices([], [{ name: "mouth", dimensions: 2 }]).map(([to]) => to)).toContain("pad/mouth/y");
    expect(drawnRange(newTarget("pad/mouth/x"))).toEqual({ low: -0.5, high: 0.5 });
    const still = { ...turn, low: 0.1, high: 0.1, below: null };
    expect(drawnRange(still).high).toBeGreaterThan(0.1);
  });

  it("says what is wrong with a name, and finds one that is free", () => {
    expect(wrongName("a b", [])).toContain("the space");
    expect(wrongName("mouth", ["mouth"])).toContain("already");
    expect(wrongName("", [])).not.toBe("");
    expect(wrongName("mouth", ["jaw"])).toBe("");
    expect(freeName("mouth", ["mouth", "mouth-2"], 40)).toBe("mouth-3");
    expect(freeName("m".repeat(40), [], 40)).toHaveLength(40);
  });
});
