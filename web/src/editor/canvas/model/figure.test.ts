import { describe, expect, it } from "vitest";
import type { Followers } from "../../session/control_net";
import { EASE, Figure, follow } from "./figure";
import { patch } from "./skin_patch";

const worn = { source: "#1", moves: undefined, net: null };

/** The farthest that two lists of numbers are apart. */
const apart = (a: ArrayLike<number>, b: ArrayLike<number>): number =>
  Array.from(a, (value, at) => Math.abs(value - (b[at] as number))).reduce(
    (most, difference) => Math.max(most, difference),
    0,
  );

describe("Figure", () => {
  const { positions, tangents } = patch();
  const field = (row: number, vector: readonly number[]) => {
    const rowsOfTexels = new Float32Array((4 * positions.length) / 3);
    rowsOfTexels.set(vector, 4 * row);
    return rowsOfTexels;
  };

  it("moves by its tangents times the field", () => {
    const figure = new Figure("round", positions, tangents);
    figure.move(field(40, [0.02, 0.003, 0.1]), null);
    const moved = [...figure.live.slice(120, 123)];
    expect(apart(moved, [0.002, 0.003, 0.1 + 0.01])).toBeLessThan(1e-6);
    figure.move(undefined, null);
    expect(figure.live).toEqual(figure.rest);
  });

  it("shows no jump when the true shape comes, and ends at it", () => {
    const figure = new Figure("round", positions, tangents);
    figure.move(field(40, [0.02, 0, 0]), null);
    const shown = figure.live.slice();
    const truth = positions.map((value, at) => value + (at === 120 ? 0.0017 : 0));
    const { greatest, mean, move } = figure.wear(worn, truth, undefined, null, 5);
    const at = (time: number) => figure.live.map((value, n) => value + figure.lag(time) * (figure.offset[n] as number));
    expect(apart(at(5), shown)).toBeLessThan(1e-6);
    expect(figure.lag(5 + EASE)).toBe(0);
    expect(figure.live).toEqual(truth);
    expect(greatest).toBeCloseTo(0.0003, 6);
    expect(mean).toBeCloseTo(0.0003, 6);
    expect(move).toBeCloseTo(0.002, 6);
  });

  it("eases on from where it is when another shape comes meanwhile", () => {
    const figure = new Figure("round", positions, tangents);
    figure.wear(
      worn,
      positions.map((value) => value + 0.001),
      undefined,
      null,
      0,
    );
    const half = figure.live.map((value, n) => value + figure.lag(EASE / 2) * (figure.offset[n] as number));
    figure.wear(worn, positions, undefined, null, EASE / 2);
    const now = figure.live.map((value, n) => value + figure.lag(EASE / 2) * (figure.offset[n] as number));
    expect(apart(now, half)).toBeLessThan(1e-6);
  });
});

it("lets rows follow by their shares", () => {
  const base = Float32Array.from([0, 0, 0, 1, 0, 0, 2, 0, 0]);
  const moved = Float32Array.from([0, 0.4, 0, 1, 0.8, 0, 2, 0, 0]);
  const followers: Followers = {
    rows: Uint32Array.of(2),
    anchors: Uint32Array.of(0, 1),
    shares: Float32Array.of(0.25, 0.75),
    links: 2,
  };
  follow(moved, base, followers);
  expect(moved[7]).toBeCloseTo(0.7, 6);
});
