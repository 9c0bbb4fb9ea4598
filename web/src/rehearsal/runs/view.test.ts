import { expect, it } from "vitest";
import { axisTime, pan, pinch, within, zoomAt } from "./view";

const WHOLE = { min: -10, max: 90 };

it("stays within the whole, and no shorter than a second", () => {
  expect(within({ min: -50, max: -30 }, WHOLE)).toEqual({ min: -10, max: 10 });
  expect(within({ min: 0, max: 500 }, WHOLE)).toEqual(WHOLE);
  expect(within({ min: 5, max: 5 }, WHOLE)).toEqual({ min: 4.5, max: 5.5 });
});

it("zooms about a time, which stays where it is", () => {
  const view = zoomAt({ min: 0, max: 40 }, 0.5, 10, WHOLE);
  expect(view).toEqual({ min: 5, max: 25 });
  expect(zoomAt(view, 100, 10, WHOLE)).toEqual(WHOLE);
});

it("moves by a part of what shows, to the end", () => {
  expect(pan({ min: 0, max: 40 }, 0.5, WHOLE)).toEqual({ min: 20, max: 60 });
  expect(pan({ min: 0, max: 40 }, 9, WHOLE)).toEqual({ min: 50, max: 90 });
});

it("keeps the times under the fingers", () => {
  expect(pinch({ min: 0, max: 40 }, [0.5], [0.25], WHOLE)).toEqual({ min: 10, max: 50 });
  const view = pinch({ min: 0, max: 40 }, [0.25, 0.75], [0.25, 0.5], { min: -1000, max: 1000 });
  expect(view.max - view.min).toBeCloseTo(80);
  expect(view.min + 0.375 * (view.max - view.min)).toBeCloseTo(20); // the middle of both
});

it("writes times at the axis before the beginning of A too, each its own", () => {
  expect([-12, -0.5, -0.01, 0, 0.5, 249, 3661].map(axisTime)).toEqual([
    "−00:12",
    "−00:00.5",
    "00:00",
    "00:00",
    "00:00.5",
    "04:09",
    "1:01:01",
  ]);
});
