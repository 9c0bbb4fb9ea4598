import { describe, expect, it } from "vitest";
import type { Triple } from "../math/vectors";
import { answered, answeredPlaces, bell, type DragOptions, dragGroup, moved } from "./drag_vectors";
import { patch, still } from "./skin_patch";

const { net, fans, positions } = patch();
const REINS: DragOptions = { falloff: 0, mirror: false, mask: null };
const go = (led: number[], dragOptions: Partial<DragOptions> = {}) =>
  dragGroup(net, led, { ...REINS, ...dragOptions }, { fans, lips: null, positions });
const vector = (vectors: Float64Array, place: number) => [...vectors.slice(3 * place, 3 * place + 3)];

it("falls like a bell", () => {
  expect(bell(0)).toBe(1);
  expect(bell(1)).toBe(0);
  expect(bell(2)).toBe(0);
  for (let x = 0; x < 1; x += 0.1) expect(bell(x + 0.1)).toBeLessThan(bell(x));
});

describe("dragGroup", () => {
  it("is who is led, without falloff", () => {
    expect([...go([0, 3]).shares]).toEqual([
      [0, 1],
      [3, 1],
    ]);
  });

  it("takes neighbours along by their distance on the skin", () => {
    const { shares } = go([0], { falloff: 30 });
    expect(shares.get(0)).toBe(1);
    const [beside, above] = [shares.get(1) as number, shares.get(3) as number];
    expect(beside).toBeGreaterThan(0);
    expect(beside).toBeCloseTo(shares.get(2) as number, 5); // as far on the other side
    expect(above).toBeCloseTo(beside, 2); // two centimetres both, but around the bend
    expect(go([0], { falloff: 15 }).shares.size).toBe(1);
  });

  it("moves nobody outside the region", () => {
    const mask = new Uint8Array(81);
    mask[net.rows[1] as number] = 128;
    expect(go([0], { mask }).led).toEqual([]);
    const { led, shares } = go([1], { mask, falloff: 100 });
    expect(led).toEqual([1]);
    expect([...shares.keys()]).toEqual([1]);
  });

  it("answers for images too", () => {
    expect(answeredPlaces(go([1], { mirror: true }))).toEqual([1, 2]);
    expect(answeredPlaces(go([0], { mirror: true }))).toEqual([0]);
  });
});

describe("moved", () => {
  it("does on the other side what it does on this one", () => {
    const out = moved(still(), go([1], { mirror: true }), [0.1, 0.02, 0.05]);
    expect(vector(out, 1)).toEqual([0.1, 0.02, 1.05]);
    expect(vector(out, 2)).toEqual([-0.1, 0.02, 1.05]);
  });

  it("keeps the midline in the middle when both sides are one", () => {
    expect(vector(moved(still(), go([0], { mirror: true }), [0.1, 0.02, 0]), 0)).toEqual([0, 0.02, 1]);
    expect(vector(moved(still(), go([0]), [0.1, 0.02, 0]), 0)).toEqual([0.1, 0.02, 1]);
  });

  it("moves a pair that is led together by one of them only once", () => {
    const out = moved(still(), go([1, 2], { mirror: true }), [0.1, 0, 0]);
    expect(vector(out, 1)[0]).toBeCloseTo(-(vector(out, 2)[0] as number), 12);
  });

  it("leaves all others where they are, and ratios positive", () => {
    const out = moved(still(), go([3]), [0, 0, -5]);
    expect(out[11]).toBeGreaterThan(0);
    expect(vector(out, 0)).toEqual([0, 0, 1]);
  });
});

it("puts a point where it is asked to lie", () => {
  const answer: [Triple, Triple, Triple] = [
    [0.1, 0, 0.01],
    [0, 1, 0],
    [0.02, 0, 0.1],
  ];
  const from: Triple = [0.01, 0.02, 0.1];
  const to: Triple = [0.013, 0.017, 0.103];
  const move = answered(answer, from, to) as Triple;
  for (const axis of [0, 1, 2] as const) {
    const reached =
      from[axis] + [0, 1, 2].reduce((sum, n) => sum + (answer[n] as Triple)[axis] * (move[n] as number), 0);
    expect(reached).toBeCloseTo(to[axis], 12);
  }
  expect(answered(undefined, from, to)).toBeUndefined();
});
