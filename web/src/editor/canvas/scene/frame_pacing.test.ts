import { expect, it, vi } from "vitest";
import { FramePacing } from "./frame_pacing";

it("counts a hand's wait until the frame in which the others followed is finished", () => {
  const pace = new FramePacing();
  let done = false;
  pace.moved(100);
  pace.moved(104); // the first of several counts
  pace.frame(false, () => true);
  pace.look(111);
  expect(pace.waits).toEqual([]);
  pace.frame(true, () => done);
  pace.look(125);
  expect(pace.waits).toEqual([]);
  expect(pace.busy).toBe(true);
  done = true;
  pace.look(131);
  expect(pace.waits).toEqual([31]);
  expect(pace.busy).toBe(false);
});

it("measures intervals between finished frames, none across a pause", () => {
  const pace = new FramePacing();
  for (const time of [0, 20, 40]) {
    pace.frame(false, () => true);
    pace.look(time);
  }
  pace.idle();
  pace.frame(false, () => true);
  pace.look(500);
  expect(pace.intervals).toEqual([20, 20]);
  expect(pace.fps).toBe(50);
  expect(pace.drawn).toBe(4);
});

it("goes on when the frame is finished, or none is waited for any more", () => {
  vi.useFakeTimers();
  const pace = new FramePacing();
  const next = vi.fn();
  let done = false;
  pace.frame(false, () => done);
  pace.whenDone(next);
  vi.advanceTimersByTime(100);
  expect(next).not.toHaveBeenCalled();
  done = true;
  vi.advanceTimersByTime(100);
  expect(next).toHaveBeenCalledTimes(1);
  pace.frame(false, () => false);
  pace.whenDone(next);
  pace.end();
  vi.advanceTimersByTime(100);
  expect(next).toHaveBeenCalledTimes(2);
  expect(vi.getTimerCount()).toBe(0);
  vi.useRealTimers();
});
