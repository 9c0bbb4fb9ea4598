import { expect, it } from "vitest";
import { Pace } from "./pace";

it("counts a hand's wait until the frame in which the others followed is finished", () => {
  const pace = new Pace();
  let done = false;
  pace.moved(100);
  pace.moved(104); // the first of several counts
  pace.frame(110, false, () => true);
  pace.look(111);
  expect(pace.waits).toEqual([]);
  pace.frame(120, true, () => done);
  pace.look(125);
  expect(pace.waits).toEqual([]);
  done = true;
  pace.look(131);
  expect(pace.waits).toEqual([31]);
});

it("measures intervals between frames, none across a pause", () => {
  const pace = new Pace();
  for (const time of [0, 20, 40]) pace.frame(time, false, () => true);
  pace.idle();
  pace.frame(500, false, () => true);
  expect(pace.intervals).toEqual([20, 20]);
  expect(pace.fps).toBe(50);
  expect(pace.drawn).toBe(4);
});
