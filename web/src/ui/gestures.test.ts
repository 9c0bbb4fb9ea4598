import { describe, expect, it } from "vitest";
import { placeIn, strayClickStopper } from "./gestures";

describe("the place of a pointer", () => {
  it("is 0 to 1 from the left and from the bottom", () => {
    const box = { left: 10, bottom: 110, width: 50, height: 100 };
    expect(placeIn(box, 10, 110, [9, 9])).toEqual([0, 0]);
    expect(placeIn(box, 60, 10, [9, 9])).toEqual([1, 1]);
    expect(placeIn(box, 35, 85, [9, 9])).toEqual([0.5, 0.25]);
  });

  it("is the last one on a control of no size, and never moves there", () => {
    for (const size of [
      { width: 0, height: 0 },
      { width: 50, height: 0 },
      { width: 0, height: 50 },
    ]) {
      const places = [0, 40, 80].map((y) => placeIn({ left: 0, bottom: 40, ...size }, 20, y, [0.3, 0.7]));
      expect(places.flat().every(Number.isFinite)).toBe(true);
      if (size.height === 0) expect(new Set(places.map(([, y]) => y))).toEqual(new Set([0.7]));
      if (size.width === 0) expect(new Set(places.map(([x]) => x))).toEqual(new Set([0.3]));
    }
  });
});

it("a double click's second click is heard where the first was, and nowhere else", () => {
  const [create, row] = [new EventTarget(), new EventTarget()];
  const hear = strayClickStopper();
  const stopped = (target: EventTarget, detail: number): boolean => {
    let calls = 0;
    const stop = (): void => {
      calls += 1;
    };
    hear({ detail, composedPath: () => [target], stopPropagation: stop, preventDefault: stop });
    return calls === 2;
  };
  expect([stopped(create, 1), stopped(row, 2)]).toEqual([false, true]);
  expect([stopped(row, 1), stopped(row, 2), stopped(row, 3)]).toEqual([false, false, false]);
});
