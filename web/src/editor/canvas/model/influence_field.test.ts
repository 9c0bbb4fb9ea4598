import { describe, expect, it } from "vitest";
import type { Muscle } from "../../session/control_net";
import { addField, reachOf } from "./influence_field";
import { patch, still } from "./skin_patch";

const NO_PULLS = new Map<string, number>();
const moves = (vectors = still(), pulls = NO_PULLS) => ({ vectors, pulls });

describe("addField", () => {
  const { net, positions } = patch();
  const reach = reachOf(net);
  const blank = () => new Float32Array((4 * positions.length) / 3);

  it("is each point's vector at its own vertex, and its share beside", () => {
    const now = still();
    now.set([0.1, 0.002, 1.05], 3);
    const field = blank();
    expect(addField(field, reach, [], moves(now), moves())).toBe(true);
    const row = net.rows[1] as number;
    expect([...field.slice(4 * row, 4 * row + 3)]).toEqual([...Float32Array.from([0.1, 0.002, 1.05 - 1])]);
    expect(field[4 * (row + 1)]).toBeCloseTo(0.05, 7);
    expect(field.filter((value) => value !== 0)).toHaveLength(6);
  });

  it("is nothing where nothing moved", () => {
    const field = blank();
    expect(addField(field, reach, [], moves(), moves())).toBe(false);
    expect(field.every((value) => value === 0)).toBe(true);
  });

  it("adds muscles by how much more they pull", () => {
    const muscle = { name: "lifter", field: new Float32Array(positions.length).fill(0.5) } as unknown as Muscle;
    const field = blank();
    addField(
      field,
      reach,
      [muscle],
      moves(still(), new Map([["lifter", 0.75]])),
      moves(still(), new Map([["lifter", 0.25]])),
    );
    expect(field[0]).toBeCloseTo(0.25, 7);
    expect(field[3]).toBe(0);
  });

  it("forgets what it is told twice", () => {
    const now = still();
    now[0] = 0.3;
    const field = blank();
    addField(field, reach, [], moves(now), moves());
    addField(field, reach, [], moves(), moves(now));
    for (const value of field) expect(value).toBeCloseTo(0, 7);
  });
});
