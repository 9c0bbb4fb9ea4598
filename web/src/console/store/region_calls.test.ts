import { describe, expect, it } from "vitest";
import type { CallState } from "../../link/messages";
import {
  calledRegions,
  callMessage,
  nextPlace,
  PLACES,
  regionalMixes,
  regionMark,
  shownOf,
  targetsOf,
} from "./region_calls";

const CALL = { character: "one", id: "1", name: "joy", seconds: 0.5, easing: "smooth" };
const AIR = { expressions: { joy: 1 }, regions: { brows: { surprise: 0.75, joy: 0.25 }, eyes: { surprise: 1 } } };

describe("the message of a call", () => {
  it("names the region of an expression, none for the whole face, and has none for a face", () => {
    expect(callMessage("expression", CALL, "brows")).toEqual({ type: "call_expression", ...CALL, region: "brows" });
    expect(callMessage("expression", CALL)).toEqual({ type: "call_expression", ...CALL, region: null });
    expect(callMessage("face", CALL, "brows")).toEqual({ type: "call_face", ...CALL });
  });
});

describe("the place of the next calls", () => {
  it("goes round by its key, in both directions", () => {
    let place = PLACES[0] ?? null;
    const round = PLACES.map(() => {
      place = nextPlace(place, 1);
      return place;
    });
    expect(round).toEqual([...PLACES.slice(1), null]);
    for (const region of PLACES) expect(nextPlace(nextPlace(region, 1), -1)).toBe(region);
  });
});

describe("what is on air in regions", () => {
  it("is the mix of a region that goes its own way, elsewhere that of the face", () => {
    expect(shownOf("joy", AIR)).toEqual({ weight: 1, regions: ["brows", "mouth", "rest"] });
    expect(shownOf("surprise", AIR)).toEqual({ weight: 1, regions: ["brows", "eyes"] });
    expect(shownOf("cry", AIR)).toEqual({ weight: 0, regions: [] });
    expect(shownOf("joy", { expressions: { joy: 1 }, regions: { brows: { joy: 0.9, cry: -0.05 } } }).weight).toBe(1);
  });

  it("is marked by words or letters, and not at all where it is the whole face", () => {
    const mark = (name: string) => regionMark(shownOf(name, AIR));
    expect([mark("joy"), mark("surprise"), mark("cry")]).toEqual(["B M R", "B E", ""]);
    expect(regionMark(shownOf("joy", { ...AIR, regions: {} }))).toBe("");
    expect(regionMark(shownOf("cry", { ...AIR, regions: { mouth: { cry: 1 } } }))).toBe("mouth");
  });

  it("is coming wherever it is called", () => {
    const call = (target: string) => ({ target }) as CallState;
    expect([...targetsOf(call("joy"), { brows: call("cry") })]).toEqual(["joy", "cry"]);
    expect(targetsOf(null).size).toBe(0);
  });

  it("is listed by region, the heaviest first", () => {
    expect(regionalMixes({ ...AIR, layers: {} })).toEqual([
      ["brows", "surprise", 0.75],
      ["brows", "joy", 0.25],
      ["eyes", "surprise", 1],
    ]);
    expect(regionalMixes({ expressions: {}, regions: {}, layers: {} })).toEqual([]);
  });

  it("is not listed where a source has put a region to rest, and is where somebody has called that", () => {
    const tracker = { influence: [1], on: true, trust: 1, source: "phone", share: 1, strongest: {}, sources: [] };
    const regions = { brows: { neutral: 1 }, mouth: { neutral: 0.4, joy: 0.6 } };
    const expressions = { joy: 1 };
    const listed = regionalMixes({ expressions, regions, layers: { tracker } });
    expect(listed.map(([region]) => region)).toEqual(["mouth", "mouth"]);
    expect(regionalMixes({ expressions, regions, layers: {} })[0]).toEqual(["brows", "neutral", 1]);
  });

  it("is nobody's call where speech has the mouth of the face step back", () => {
    const lips = {
      influence: [0, 0, 0.7, 0],
      on: true,
      trust: 1,
      source: "speech",
      share: 0.5,
      strongest: {},
      sources: [],
    };
    const expressions = { joy: 0.8, cry: 0.1, neutral: 0.1 };
    const regions = { mouth: { joy: 0.4, cry: 0.05, neutral: 0.55 } };
    expect(calledRegions({ expressions, regions, layers: { lips } })).toEqual({});
    expect(calledRegions({ expressions, regions, layers: {} })).toEqual(regions);
    expect(
      calledRegions({ expressions: { neutral: 1 }, regions: { mouth: { neutral: 1 } }, layers: { lips } }),
    ).toEqual({});
    for (const mouth of [{ neutral: 1 }, { cry: 1 }, { joy: 0.4, cry: 0.2, neutral: 0.4 }])
      expect(calledRegions({ expressions, regions: { mouth }, layers: { lips } })).toEqual({ mouth });
  });
});
