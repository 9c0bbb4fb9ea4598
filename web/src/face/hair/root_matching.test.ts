import { describe, expect, it } from "vitest";
import { type Arc, arcStyle } from "./arc_style";
import { matchRoots, woundStrands } from "./root_matching";

const crown: Arc = { root: [0, 1, 0], toward: [1, 0, 0], length: 0.8, height: 0.005 };
const brow: Arc = { root: [0, 0.5, 1], toward: [0, -1, 0], length: 0.4, height: 0.005 };

describe("the matches of a style", () => {
  it("of itself are its own strands, wholly", () => {
    const matches = matchRoots(arcStyle([crown, brow]), arcStyle([crown, brow]));
    expect([[...matches.strand], [...matches.same]]).toEqual([
      [0, 1],
      [1, 1],
    ]);
  });

  it("are the nearest roots, and none where the other style is bald", () => {
    const beside: Arc = { ...brow, root: [0.03, 0.5, 1] };
    const matches = matchRoots(arcStyle([crown, brow]), arcStyle([beside]));
    expect([...matches.same]).toEqual([0, 1]);
  });

  it("fade as the other root is farther off", () => {
    const same = [0, 0.1, 0.12, 0.15, 0.3].map((aside) => {
      const other = arcStyle([{ ...crown, root: [aside, 1, 0] }]);
      return matchRoots(arcStyle([crown]), other).same[0] as number;
    });
    expect([same[0], same[4]]).toEqual([1, 0]);
    for (let at = 1; at < same.length; at++) expect(same[at]).toBeLessThanOrEqual(same[at - 1] as number);
  });

  it("fade as the other strand is combed round the other side of the head", () => {
    const same = [0, 0.6, 1.2, 2, Math.PI].map((turn) => {
      const other = { ...crown, length: 1.4, toward: [Math.cos(turn), 0, Math.sin(turn)] as const };
      return matchRoots(arcStyle([{ ...crown, length: 1.4 }]), arcStyle([other])).same[0] as number;
    });
    expect([same[0], same[4]]).toEqual([1, 0]);
    for (let at = 1; at < same.length; at++) expect(same[at]).toBeLessThanOrEqual(same[at - 1] as number);
  });

  it("leave out what is wound up", () => {
    const coil: Arc = { ...crown, length: 4.5 };
    expect([...woundStrands(arcStyle([crown, coil]))]).toEqual([0, 1]);
    expect([...matchRoots(arcStyle([coil]), arcStyle([crown])).same]).toEqual([0]);
    expect([...matchRoots(arcStyle([crown]), arcStyle([coil])).same]).toEqual([0]);
  });

  it("are none between strands of other numbers of places", () => {
    const short = { ...arcStyle([crown]), stations: 4 };
    expect([...matchRoots(arcStyle([crown]), short).same]).toEqual([0]);
  });
});
