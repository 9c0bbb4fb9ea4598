import { expect, it } from "vitest";
import { FINE_NUDGE, NUDGE, nudgeOf } from "./nudge_keys";

const press = (key: string, shiftKey = false, altKey = false) => nudgeOf({ key, shiftKey, altKey });

it("nudges on the screen, finer with Shift, off the surface with Alt", () => {
  expect(press("ArrowLeft")).toEqual([-NUDGE, 0, 0]);
  expect(press("ArrowUp", true)).toEqual([0, FINE_NUDGE, 0]);
  expect(press("ArrowDown", false, true)).toEqual([0, 0, -NUDGE]);
  expect(press("ArrowRight", false, true)).toBeUndefined();
  expect(press("a")).toBeUndefined();
});
