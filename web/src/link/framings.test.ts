import { expect, it } from "vitest";
import { SHOT_SIZES } from "./constants";
import { heldBy, inSize, PORTRAIT_SIZE, showsFigures, sizeOf, weightsBy } from "./framings";

it("a framing says whom it holds and how much of them; one of another version is a portrait", () => {
  for (const held of ["*", "one", "kaori+one"]) {
    for (const size of SHOT_SIZES) expect([heldBy(`${held}:${size}`), sizeOf(`${held}:${size}`)]).toEqual([held, size]);
    for (const size of SHOT_SIZES)
      expect([heldBy, sizeOf].map((read) => read(inSize(held, size)))).toEqual([held, size]);
    expect(inSize(held, PORTRAIT_SIZE)).toBe(held);
    for (const plain of [held, `${held}:knees`])
      expect([heldBy(plain), sizeOf(plain), showsFigures([plain])]).toEqual([held, PORTRAIT_SIZE, false]);
  }
  expect(showsFigures(["*", "one:bust"])).toBe(true);
});

it("weights are summed by whom framings hold, and by size", () => {
  const mix = { "*": 0.25, "*:full": 0.5, "one:full": 0.25 };
  expect([...weightsBy(mix, heldBy)]).toEqual([
    ["*", 0.75],
    ["one", 0.25],
  ]);
  expect([...weightsBy(mix, sizeOf)]).toEqual([
    [PORTRAIT_SIZE, 0.25],
    ["full", 0.75],
  ]);
});
