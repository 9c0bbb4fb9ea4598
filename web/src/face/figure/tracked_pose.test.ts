import { expect, it } from "vitest";
import type { TrackedState } from "../../link/messages";
import { mixTracked, trackedKey } from "../pose/tracked_mix";
import type { Skeleton } from "./skeleton";
import { putTracked } from "./tracked_pose";

const NAMES = ["root", "spine01", "head", "wrist.L", "wrist.R"];
const SKELETON: Skeleton = {
  names: NAMES,
  parents: [-1, 0, 1, 1, 1],
  places: new Map(NAMES.map((name, at) => [name, at])),
};
const COUNT = 3 * NAMES.length + 15;

/** Numbers as a link brings them: not at the beginning of their buffer. */
function body(shares: number[], number: (at: number) => number): TrackedState {
  const bytes = new Uint8Array(2 * COUNT + 1);
  const view = new DataView(bytes.buffer, 1);
  for (let at = 0; at < COUNT; at++) view.setInt16(2 * at, number(at), true);
  return { shares, pose: bytes.subarray(1) };
}

const pose = () => ({
  turns: new Float64Array(3 * NAMES.length).fill(0.1),
  travel: new Float64Array(3).fill(0.2),
  feet: new Float64Array(6).fill(0.3),
  feetTurns: new Float64Array(6).fill(0.4),
});

it("shows in place of what is called, region by region and by its share", () => {
  const put = pose();
  putTracked(
    body([0, 1, 0.5, 0, 1], () => 32767),
    SKELETON,
    put,
  );
  const bones = NAMES.map((_, bone) => put.turns[3 * bone]);
  [3.5, 3.5, 0.1, 0.05 + 1.75, 0.1].forEach((wanted, at) => {
    expect(bones[at]).toBeCloseTo(wanted, 12);
  });
  expect([put.travel[2], put.feet[5], put.feetTurns[5]]).toEqual([3, 3, 3.5]);
  const other = pose();
  putTracked({ ...body([1, 1, 1, 1, 1], () => 1), pose: new Uint8Array(4) }, SKELETON, other);
  expect(other).toEqual(pose());
});

it("comes and goes by its shares alone, and moves between two states", () => {
  const [first, second] = [body([0, 1, 1, 1, 1], (at) => at), body([1, 1, 1, 1, 0], (at) => at + 100)];
  const half = mixTracked(first, second, 0.5) as TrackedState;
  expect(half.shares).toEqual([0.5, 1, 1, 1, 0.5]);
  expect(trackedKey({ ...half, shares: [] })).toBe(trackedKey({ ...body([], (at) => at + 50), shares: [] }));
  expect(mixTracked(undefined, second, 0.25)).toEqual({ shares: [0.25, 0.25, 0.25, 0.25, 0], pose: second.pose });
  expect(mixTracked(first, undefined, 0.25)?.shares).toEqual([0, 0.75, 0.75, 0.75, 0.75]);
  expect(mixTracked(undefined, undefined, 0.5)).toBeUndefined();
});

it("turns on beyond half a turn, and not back through the front", () => {
  const [first, second] = [body([1], () => 29000), body([1], () => -29000)];
  expect(trackedKey(mixTracked(first, second, 0.5))).toBe(trackedKey(second));
});
