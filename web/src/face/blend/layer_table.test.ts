import { describe, expect, it } from "vitest";
import { LayerTable } from "./layer_table";

describe("the layer table", () => {
  it("never gives one layer to two keys that are kept", () => {
    const table = new LayerTable(4, 8);
    const keep = new Set(["a", "b", "c", "d", "e", "f"]);
    const layers = [...keep].map((key) => table.take(key, keep));
    expect(new Set(layers)).toEqual(new Set([0, 1, 2, 3, 4, 5]));
    for (const [n, key] of [...keep].entries()) expect(table.use(key)).toBe(layers[n]);
  });

  it("reuses the least recently used before it opens more than it prefers", () => {
    const table = new LayerTable(3, 8);
    for (const key of ["a", "b", "c"]) table.take(key, new Set());
    table.use("a");
    expect(table.take("d", new Set())).toBe(1);
    expect(table.has("b")).toBe(false);
    expect(table.has("a")).toBe(true);
  });

  it("grows when all are kept and refuses at its limit", () => {
    const table = new LayerTable(1, 2);
    const keep = new Set(["a", "b", "c"]);
    expect(table.take("a", keep)).toBe(0);
    expect(table.take("b", keep)).toBe(1);
    expect(table.take("c", keep)).toBeUndefined();
    expect(table.use("c")).toBeUndefined();
  });
});
