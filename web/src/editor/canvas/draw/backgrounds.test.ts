import { expect, it } from "vitest";
import { packed } from "./backgrounds";

it("gives parts as shares of the canvas, each with its colour", () => {
  const backgrounds = [
    { part: [0, 0, 400, 200], colour: [0.1, 0.2, 0.3] },
    { part: [100, 50, 40, 20], colour: [1, 0, 0] },
  ] as const;
  const numbers = [...packed(backgrounds, 400, 200)];
  expect(numbers).toHaveLength(14);
  expect(numbers.slice(0, 4)).toEqual([0, 0, 1, 1]);
  [0.25, 0.25, 0.1, 0.1, 1, 0, 0].forEach((value, at) => {
    expect(numbers[7 + at]).toBeCloseTo(value);
  });
});
