import { beforeEach, describe, expect, it } from "vitest";
import { faderDrag, placeIn, strayClickStopper } from "./gestures";

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

let value: number;
let gripped: boolean;
let era: number;
const knob = {
  value: () => value,
  gripped: () => gripped,
  grip: (to: number) => {
    [value, gripped] = [to, true];
  },
  leave: () => {
    gripped = false;
  },
};
const drag = faderDrag({
  knob: () => knob,
  era: () => era,
  range: { low: 0, high: 2 },
  rest: () => {
    value = 0;
  },
});

beforeEach(() => {
  [value, gripped, era] = [0.5, false, 0];
});

describe("the drag of a fader", () => {
  it("goes on from what is on air, by the way of the hand, to the ends of the range", () => {
    drag.start(0, 0);
    drag.move(0, 0.25);
    expect([value, gripped]).toEqual([1, true]);
    drag.move(0, 5);
    drag.move(0, -0.5);
    expect(value).toBe(1);
    drag.end();
    expect(gripped).toBe(false);
  });

  it("begins anew where another hand has moved it meanwhile", () => {
    drag.start(0, 0);
    drag.move(0, 0.25);
    [value, gripped] = [0.2, false];
    drag.move(0, 0.1);
    expect(value).toBeCloseTo(0.4);
  });

  it("ends with a panic, and rests when it is tapped twice", () => {
    drag.start(0, 0);
    era += 1;
    drag.move(0, 0.25);
    expect(value).toBe(0.5);
    drag.double?.();
    expect(value).toBe(0);
  });
});
