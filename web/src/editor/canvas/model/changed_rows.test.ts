import { describe, expect, it } from "vitest";
import { ChangedRows } from "./changed_rows";
import { patch } from "./skin_patch";

const { fans } = patch();
const field = (...rows: number[]) => {
  const rowsOfTexels = new Float32Array(4 * 81);
  for (const row of rows) rowsOfTexels[4 * row + 1] = 0.1;
  return rowsOfTexels;
};

describe("ChangedRows", () => {
  it("names what moves, what moved before, and turns what is around", () => {
    const changedRows = new ChangedRows(fans);
    const first = changedRows.after([field(40)], []);
    expect([...first.moved]).toEqual([40]);
    expect([...first.turned]).toEqual([31, 32, 39, 40, 41, 48, 49]);
    expect([...changedRows.after([field(42)], []).moved]).toEqual([40, 42]);
    expect([...changedRows.after([], []).moved]).toEqual([42]);
    expect([...changedRows.after([], []).moved]).toEqual([]);
  });

  it("lets followers move with their anchors, and rows that ease", () => {
    const changedRows = new ChangedRows(fans);
    changedRows.setFollowers({
      rows: Uint32Array.of(80, 79),
      anchors: Uint32Array.of(40, 0, 41, 42),
      shares: Float32Array.of(1, 0, 0.5, 0.5),
      links: 2,
    });
    const offset = new Float32Array(3 * 81);
    offset[3 * 5 + 2] = 0.001;
    expect([...changedRows.after([field(40)], [offset]).moved]).toEqual([5, 40, 80]);
    expect([...changedRows.after([field(0)], []).moved]).toEqual([0, 5, 40, 80]); // a share of nothing is none
    expect([...changedRows.after([field(41)], []).moved]).toEqual([0, 41, 79]);
  });

  it("can name all", () => {
    expect(new ChangedRows(fans).all.moved).toHaveLength(81);
  });
});
