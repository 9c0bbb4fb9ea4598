import { beforeEach, expect, it } from "vitest";
import { Curtain } from "./curtain";

let seen: number[];
let curtain: Curtain;

beforeEach(() => {
  seen = [];
  curtain = new Curtain((share) => seen.push(share));
});

/** Frames at 60 Hz for some seconds. */
function frames(seconds: number, black = 0, whole = true): void {
  for (let frame = 0; frame < Math.ceil(60 * seconds); frame++) curtain.frame(black, 1 / 60, whole);
}

it("is black until the picture is whole, and comes up in half a second without a jump", () => {
  frames(2, 0, false);
  expect(seen).toEqual([0]);
  frames(0.51);
  expect([seen.at(-1), curtain.open]).toEqual([1, true]);
  const steps = seen.map((share, at) => share - (seen[at - 1] ?? 0));
  expect(Math.min(...steps)).toBeGreaterThanOrEqual(0);
  expect(Math.max(...steps)).toBeLessThan(1.6 / 30);
});

it("does not wait for ever for what never comes, and not at all for what is no show", () => {
  frames(11, 0, false);
  expect(seen.at(-1)).toBe(1);
  curtain = new Curtain((share) => seen.push(share));
  curtain.raise(0.25);
  expect([seen.at(-1), curtain.open]).toEqual([0.75, true]);
});

it("shows the way up also where the first frames take long", () => {
  curtain.frame(0, 3, true);
  expect(seen.at(-1)).toBeLessThan(0.2);
});

it("is as black as the show, also while it comes up, and says what changes alone", () => {
  frames(1, 1);
  expect(seen).toEqual([0]);
  frames(1, 0.25);
  expect(seen).toEqual([0, 0.75]);
});
