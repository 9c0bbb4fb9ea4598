import { expect, it } from "vitest";
import { mixLabel, onAir } from "./axis";

it("lists what is on air, heaviest first, without dust", () => {
  expect(onAir({ a: 0.2, b: 0.8, c: 0.0004, d: -0.05 })).toEqual([
    ["b", 0.8],
    ["a", 0.2],
    ["d", -0.05],
  ]);
});

it("names a mix with its weights, one alone without, and counts those for which there is no line", () => {
  const label = (name: string): string => name.toUpperCase();
  expect(mixLabel({ cat: 0.52, goblin: 0.48 }, label)).toBe("CAT 52\nGOBLIN 48");
  expect(mixLabel({ cat: 1 }, label)).toBe("CAT");
  expect(mixLabel({ cat: 0.998, dog: 0.002 }, label)).toBe("CAT");
  expect(mixLabel({ a: 0.4, b: 0.3, c: 0.2, d: 0.1 }, label)).toBe("A 40\nB 30\n+ 2 more");
  expect(mixLabel({}, label)).toBe("");
});
