import { expect, it } from "vitest";
import type { SeenPhotographs } from "./photograph_document";
import { knowledgeOf, noFace, photographAdvice } from "./photograph_words";

const seen = (count: number): SeenPhotographs =>
  ({ off: Array(count).fill(1), seen: 0.614, spread: 4.26 }) as unknown as SeenPhotographs;

it("says of one photograph what it cannot know, and of all what they show", () => {
  expect(knowledgeOf(seen(1))).toContain("it cannot know the profile. The photograph shows 61 % of the skin");
  const three = knowledgeOf(seen(3));
  expect(three).toContain("The photographs show 61 % of the skin");
  expect(three).toContain("4.3 mm off");
  expect(three).not.toContain("cannot know");
});

it("says what to do: drag what is off, fit again, take it", () => {
  expect(photographAdvice({ doubts: [] }, false)).toContain("take it");
  expect(photographAdvice({ doubts: [{ sentence: "x" }] }, false)).toContain("drag those that are off");
  expect(photographAdvice({ doubts: [{ sentence: "x" }] }, true)).toContain("Fit again");
});

it("says which photograph has no face", () => {
  expect(noFace("wall.jpg")).toContain("No face was found in wall.jpg");
});
