import { expect, it } from "vitest";
import type { SourceState } from "../../link/messages";
import { playersWords } from "./player_words";

const HAND = {
  name: "Hand Ada",
  characters: ["one"],
  regions: ["mouth", "head"],
  rate: 20,
  found: true,
} as unknown as SourceState;

it("says who plays a character beside its console, in which parts, and who is lost", () => {
  expect(playersWords([HAND], "one")).toBe("Hand Ada: mouth, head");
  expect(
    playersWords(
      [
        { ...HAND, regions: [] },
        { ...HAND, name: "Voice", found: false },
      ],
      "one",
    ),
  ).toBe("Hand Ada: all parts; Voice: lost");
  expect(playersWords([HAND], "two")).toBe("");
});
