import { expect, it } from "vitest";
import { FINE_NUDGE, NUDGE, nextPlace, nudgeOf, stepOf } from "./nudge_keys";

const press = (key: string, shiftKey = false, altKey = false) => nudgeOf({ key, shiftKey, altKey });

it("nudges on the screen, finer with Shift, off the surface with Alt", () => {
  expect(press("ArrowLeft")).toEqual([-NUDGE, 0, 0]);
  expect(press("ArrowUp", true)).toEqual([0, FINE_NUDGE, 0]);
  expect(press("ArrowDown", false, true)).toEqual([0, 0, -NUDGE]);
  expect(press("ArrowRight", false, true)).toBeUndefined();
  expect(press("a")).toBeUndefined();
});

it("goes from needle to needle, from the crown down, and around", () => {
  const heads = [0, 2, 1].map((height, place) => ({ place, head: [0, height, 0] as [number, number, number] }));
  expect([stepOf({ key: "." }), stepOf({ key: "," }), stepOf({ key: "a" })]).toEqual([1, -1, undefined]);
  const walk = (from: number | undefined, by: -1 | 1) => nextPlace(heads, from, by);
  expect([walk(undefined, 1), walk(1, 1), walk(2, 1), walk(0, 1)]).toEqual([1, 2, 0, 1]);
  expect([walk(undefined, -1), walk(1, -1), walk(7, -1)]).toEqual([0, 0, 0]);
  expect(nextPlace([], 3, 1)).toBeUndefined();
});
