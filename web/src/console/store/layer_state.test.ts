import { describe, expect, test } from "vitest";
import { LAYERS } from "../../link/constants";
import type { CharacterState, LayerState } from "../../link/messages";
import { feedWords, followTrend, influenceOf, isDriven, layerOf, shownChannels } from "./layer_state";

const tracker: LayerState = {
  influence: [1, 0.5, 0.25, 0, 1, 1],
  on: false,
  trust: 0.4,
  source: "phone",
  share: 0.4,
  strongest: { jawOpen: 0.7 },
  sources: [],
};
const air = (layers: CharacterState["layers"] = {}): CharacterState =>
  ({
    expressions: { neutral: 0.3, smile: 0.69, angry: 0.01 },
    channels: { jawOpen: 0.7 },
    held: {
      channels: { mouthFunnel: -0.4, jawOpen: 0.1, browInnerUp: 0.3, cheekPuff: 0.2 },
      head: [0, 0, 0],
      gaze: [0, 0],
    },
    layers,
  }) as unknown as CharacterState;

describe("layers of which a state says nothing", () => {
  test("are on and show as at first: nothing of a source, all of calls and hands", () => {
    for (const layer of LAYERS) {
      const { on, share, source } = layerOf(air(), layer);
      expect([on, share, source]).toEqual([true, isDriven(layer) ? 0 : 1, ""]);
    }
    expect(LAYERS.map((layer) => influenceOf(air(), layer, null))).toEqual([1, 1, 1, 1, 1, 0.7, 1, 1]);
    expect(influenceOf(air(), "lips", "brows")).toBe(0);
  });

  test("show what is called, and what hands hold, the strongest alone", () => {
    expect(layerOf(air(), "emotion").strongest).toEqual({ smile: 0.69, neutral: 0.3 });
    expect(layerOf(air(), "hands").strongest).toEqual({ mouthFunnel: -0.4, browInnerUp: 0.3, cheekPuff: 0.2 });
  });
});

test("a layer is as the state tells it, its whole where it shows most", () => {
  const state = air({ tracker });
  expect(layerOf(state, "tracker")).toBe(tracker);
  expect(influenceOf(state, "tracker", null)).toBe(1);
  expect(influenceOf(state, "tracker", "mouth")).toBe(0.25);
});

test("channels sink with the trust of their source, and none shows of one that is lost", () => {
  expect(shownChannels({ ...tracker, trust: 0.5 })).toEqual([["jawOpen", 0.35]]);
  expect(shownChannels({ ...tracker, trust: 0 })).toEqual([]);
  expect(shownChannels({ ...tracker, source: "", trust: 1 })).toEqual([["jawOpen", 0.7]]);
});

test("who feeds a layer is told in words, also where it is lost and comes back", () => {
  const says = (trusts: readonly number[]): string => {
    const trend = trusts.reduce<ReturnType<typeof followTrend> | null>(followTrend, null);
    return feedWords("tracker", tracker, trend as ReturnType<typeof followTrend>);
  };
  expect(says([1])).toBe("phone");
  expect(says([1, 0.6])).toBe("phone: fading");
  expect(says([1, 0.6, 0.6])).toBe("phone: fading"); // as long as nothing else is known
  expect(says([1, 0.6, 0])).toBe("phone: lost");
  expect(says([0, 0.2])).toBe("phone: returning");
  const at = { trust: 1, rises: false };
  expect(feedWords("tracker", { ...tracker, source: "" }, at)).toBe("no source");
  expect(feedWords("emotion", tracker, at)).toBe("calls");
  const shared = [
    { source: "phone", trust: 1, parts: ["mouth"] },
    { source: "webcam", trust: 0, parts: [] },
  ];
  expect(feedWords("tracker", { ...tracker, sources: shared }, at)).toBe("phone: mouth, webcam: lost");
  const [one, other] = ["VMC 10.0.0.7", "VMC 10.0.0.8"];
  expect(feedWords("tracker", { ...tracker, source: one }, at)).toBe("VMC");
  expect(feedWords("tracker", { ...tracker, source: one }, at, [one, other])).toBe(one);
});
