import { describe, expect, it } from "vitest";
import { HANDLES, moveHandle, rowOf } from "./photograph_handles";

const COUNT = 478;
/** Points without order, as far apart as those of a face. */
const points = Float32Array.from({ length: 3 * COUNT }, (_, at) => 0.5 + 0.4 * Math.sin(12.9898 * at * at + at));
const NOSE = HANDLES.findIndex(([label]) => label === "Tip of the nose");
const part = (rows: Float32Array, row: number, axis: number): number => rows[3 * row + axis] as number;

describe("a handle that is dragged", () => {
  it("goes where it is put, and all other handles stay", () => {
    const moved = moveHandle(points, NOSE, [0.03, -0.02], 0.75);
    HANDLES.forEach(([label], at) => {
      const row = rowOf(at);
      const by = [0, 1, 2].map((axis) => part(moved, row, axis) - part(points, row, axis));
      const wanted = at === NOSE ? [0.03, -0.02, 0] : [0, 0, 0];
      by.forEach((change, axis) => {
        expect(change, label).toBeCloseTo(wanted[axis] as number, 6);
      });
    });
  });

  it("takes what is around it along, less the further away, and keeps depth", () => {
    const near = points.slice();
    const [row, x] = [rowOf(NOSE), part(points, rowOf(NOSE), 0)];
    const away = HANDLES.map((_, at) => rowOf(at))
      .filter((other) => other !== row)
      .map((other) => Math.hypot(part(points, other, 0) - x, part(points, other, 1) - part(points, row, 1)));
    const reach = Math.min(...away);
    const others = [7, 8, 9];
    others.forEach((other, at) => {
      near.set([x + reach * ([0.2, 0.5, 1.1][at] as number), part(points, row, 1), 0.3], 3 * other);
    });
    const moved = moveHandle(near, NOSE, [0.1, 0], 1);
    const [close, further, beyond] = others.map((other) => part(moved, other, 0) - part(near, other, 0));
    expect(close).toBeLessThan(0.1);
    expect(close).toBeGreaterThan(further as number);
    expect(further).toBeGreaterThan(0);
    expect(beyond).toBe(0);
    expect(moved.filter((_, at) => at % 3 === 2)).toEqual(near.filter((_, at) => at % 3 === 2));
  });

  it("is one of fifteen with names and rows of their own", () => {
    expect(new Set(HANDLES.map(([label]) => label)).size).toBe(HANDLES.length);
    expect(new Set(HANDLES.map(([, row]) => row)).size).toBe(HANDLES.length);
    expect(Math.max(...HANDLES.map(([, row]) => row))).toBeLessThan(468);
  });
});
