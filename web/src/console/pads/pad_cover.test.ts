import { expect, it } from "vitest";
import type { CharacterState, LayerState, SourceState } from "../../link/messages";
import { coverOf } from "./pad_cover";

const HAND = { name: "Hand Ada 127.0.0.1", regions: ["mouth", "head"] } as unknown as SourceState;
const layer = (change: Partial<LayerState> = {}): LayerState => ({
  influence: [1, 1, 1, 1, 1, 1],
  on: true,
  trust: 1,
  source: HAND.name,
  share: 1,
  strongest: {},
  sources: [],
  ...change,
});
const air = (tracker: LayerState, regions: CharacterState["regions"] = { mouth: { neutral: 1 } }) => ({
  layers: { tracker },
  regions,
  expressions: { laugh: 1 },
});

it("names the source that has all that a pad plays", () => {
  expect(coverOf("mouth", air(layer()), [HAND])).toEqual({ whole: true, words: "covered by Hand Ada" });
  expect(coverOf("brows", air(layer()), [HAND])).toEqual({ whole: false, words: "" });
  expect(coverOf("face", air(layer()), [HAND])).toEqual({ whole: false, words: "" });
});

it("names the part of a pad of the whole face that a source has, and all of it where it has all", () => {
  const words = "mouth covered by Hand Ada";
  expect(coverOf("expression", air(layer()), [HAND])).toEqual({ whole: false, words });
  const rest = { neutral: 1 };
  const whole = air(layer(), { brows: rest, eyes: rest, mouth: rest, rest });
  expect(coverOf("expression", whole, [{ ...HAND, regions: [] }])).toEqual({
    whole: true,
    words: "covered by Hand Ada",
  });
});

it("is nothing where the source is lost, off, without influence there, or plays less than half", () => {
  for (const state of [
    layer({ trust: 0.2 }),
    layer({ on: false }),
    layer({ influence: [1, 1, 0, 1, 1, 1] }),
    layer({ source: "" }),
    layer({ source: "clip" }), // whose parts nobody tells
  ])
    expect(coverOf("mouth", air(state), [HAND]).words).toBe("");
  expect(coverOf("mouth", air(layer(), { mouth: { mouthFunnel: 0.8, neutral: 0.2 } }), [HAND]).words).toBe("");
});

it("asks the one of several sources that has the part", () => {
  const sources = [
    { source: "Camera Ada", trust: 1, parts: ["brows", "eyes"] },
    { source: HAND.name, trust: 1, parts: ["mouth", "head"] },
  ];
  expect(coverOf("mouth", air(layer({ source: "Camera Ada", sources })), [HAND]).words).toBe("covered by Hand Ada");
});
