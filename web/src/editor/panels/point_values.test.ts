import { expect, it } from "vitest";
import { flat, REST, type Vector } from "../session/control_net";
import { commonOf, mirrored } from "./point_values";

const vectors: Vector[] = [[0.1, 0.01, 1.1], [...REST], [0.2, 0.02, 0.9], [...REST]];
const MIRROR = [1, 0, 2, -1];

it("copies a side to the other, straightens the midline and leaves what has no image", () => {
  const copied = mirrored(vectors, [0, 2, 3], MIRROR);
  expect(copied).toEqual([[0.1, 0.01, 1.1], [-0.1, 0.01, 1.1], [0, 0.02, 0.9], [...REST]]);
  expect(mirrored(copied, [0, 1, 2, 3], MIRROR)).toEqual(copied);
});

it("a number is common only where all have it", () => {
  const live = flat(vectors);
  expect(commonOf(live, [1, 3], 2)).toBe(1);
  expect(commonOf(live, [0, 1], 0)).toBeNull();
  expect(commonOf(live, [], 0)).toBeNull();
});
