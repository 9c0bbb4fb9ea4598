import { describe, expect, it } from "vitest";
import { add, cross, dot, solved, type Triple, times } from "./vectors";

describe("solved", () => {
  it("finds the amounts of three directions that add up to a goal", () => {
    const [a, b, c]: Triple[] = [
      [0.14, 0.01, -0.03],
      [0.02, 0.9, 0.1],
      [0.05, -0.02, 0.12],
    ] as [Triple, Triple, Triple];
    const goal: Triple = [0.004, -0.007, 0.002];
    const x = solved(a as Triple, b as Triple, c as Triple, goal) as Triple;
    const sum = add(add(times(a as Triple, x[0]), times(b as Triple, x[1])), times(c as Triple, x[2]));
    for (const axis of [0, 1, 2] as const) expect(sum[axis]).toBeCloseTo(goal[axis], 12);
  });

  it("gives up where the directions lie in one plane", () => {
    expect(solved([1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1])).toBeUndefined();
    expect(solved([0, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 1])).toBeUndefined();
  });
});

it("crosses at right angles", () => {
  const [a, b]: [Triple, Triple] = [
    [1, 2, 3],
    [-2, 0.5, 4],
  ];
  expect(dot(cross(a, b), a)).toBeCloseTo(0, 12);
  expect(dot(cross(a, b), b)).toBeCloseTo(0, 12);
});
