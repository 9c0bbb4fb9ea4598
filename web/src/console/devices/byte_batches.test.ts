import { expect, it } from "vitest";
import { BATCH_MILLISECONDS, ByteBatches, LONGEST_BATCH } from "./byte_batches";

/** Batches with a clock that is moved by hand; timers run when they are told to. */
function batches() {
  const sent: [string, number[]][] = [];
  const timers: (() => void)[] = [];
  const clock = { now: 1000 };
  const batcher = new ByteBatches(
    (device, data) => sent.push([device, [...data]]),
    () => clock.now,
    (call) => void timers.push(call),
  );
  return { batcher, sent, timers, clock };
}

it("sends the first bytes at once and those of the next moment together, in their order", () => {
  const { batcher, sent, timers, clock } = batches();
  batcher.add("a", [0xb0, 7, 1]);
  expect(sent).toEqual([["a", [0xb0, 7, 1]]]);
  batcher.add("a", [0xb0, 7, 2]);
  batcher.add("b", [0x90, 60, 100]);
  batcher.add("a", [0xb0, 7, 3]);
  expect([sent.length, timers.length]).toEqual([1, 1]);
  clock.now += BATCH_MILLISECONDS;
  timers[0]?.();
  expect(sent.slice(1)).toEqual([
    ["a", [0xb0, 7, 2, 0xb0, 7, 3]],
    ["b", [0x90, 60, 100]],
  ]);
});

it("does not wait for a timer that a page out of sight gets late", () => {
  const { batcher, sent, clock } = batches();
  batcher.add("a", [0xb0, 7, 1]);
  batcher.add("a", [0xb0, 7, 2]);
  clock.now += BATCH_MILLISECONDS;
  batcher.add("a", [0xb0, 7, 3]);
  expect(sent.map(([, data]) => data)).toEqual([
    [0xb0, 7, 1],
    [0xb0, 7, 2, 0xb0, 7, 3],
  ]);
});

it("loses no byte of a flood, and sends none that the wire would not take", () => {
  const { batcher, sent, timers, clock } = batches();
  const all = Array.from({ length: 5000 }, (_, index) => index % 128);
  batcher.add("a", [0]);
  for (let at = 0; at < all.length; at += 100) batcher.add("a", all.slice(at, at + 100));
  clock.now += BATCH_MILLISECONDS;
  timers[0]?.();
  expect(sent.flatMap(([, data]) => data)).toEqual([0, ...all]);
  expect(Math.max(...sent.map(([, data]) => data.length))).toBe(LONGEST_BATCH);
});

it("passes over clocks, and sends what waits before a device is forgotten", () => {
  const { batcher, sent } = batches();
  batcher.add("a", [0xf8]);
  batcher.add("a", []);
  expect(sent).toEqual([]);
  batcher.add("a", [0xb0, 7, 1]);
  batcher.add("a", [0xb0, 7, 2]);
  batcher.forget("a");
  expect(sent.length).toBe(2);
});
