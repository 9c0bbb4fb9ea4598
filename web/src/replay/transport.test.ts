import { expect, it } from "vitest";
import { askedBy, loopFrom, type Moment, momentBeside, type Transport, wordsOf } from "./transport";

const now = (more: Partial<Transport> = {}): Transport => ({
  playing: false,
  position: 30,
  seconds: 60,
  rate: 1,
  loop: [],
  jumps: 1,
  different: null,
  failure: "",
  start: 1,
  first: 0,
  ...more,
});
const moment = (at: number): Moment => ({ at, what: "go", name: String(at), who: "ana" });
const MOMENTS = [moment(50), moment(10), moment(29.5)];
const key = (code: string, shiftKey = false) => ({ code, shiftKey });

it("goes to positions that there are", () => {
  expect(askedBy(key("ArrowLeft"), now({ position: 2 }), [])).toEqual({ position: 0 });
  expect(askedBy(key("ArrowRight"), now({ position: 58 }), [])).toEqual({ position: 60 });
  expect(askedBy(key("ArrowRight", true), now(), [])?.position).toBeCloseTo(30 + 1 / 60);
  expect(askedBy(key("KeyQ"), now(), [])).toBeUndefined();
});

it("finds the moment before and behind; one just passed is not the one before", () => {
  expect(momentBeside(MOMENTS, 30, false)?.at).toBe(10);
  expect(momentBeside(MOMENTS, 30, true)?.at).toBe(50);
  expect(askedBy(key("Period"), now({ position: 55 }), MOMENTS)).toBeUndefined();
});

it("keeps a loop's other end where it can", () => {
  expect(loopFrom(now({ loop: [10, 40] }), "begin")).toEqual([30, 40]);
  expect(loopFrom(now({ loop: [10, 20] }), "begin")).toEqual([30, 60]);
  expect(loopFrom(now({ loop: [40, 50] }), "end")).toEqual([0, 30]);
  expect(loopFrom(now({ position: 60 }), "begin")).toEqual([59.5, 60]);
});

it("says in words what happened", () => {
  expect(wordsOf({ at: 1, what: "go", name: "12", who: "ana" })).toBe("GO 12 (ana)");
});
