import { afterEach, describe, expect, it, vi } from "vitest";
import { loadPortraits } from "./portraits";
import names from "./portraits.json";
import { THUMBNAIL_SIZE } from "./thumbnails";

afterEach(() => vi.unstubAllGlobals());

describe("the portraits that come with the pages", () => {
  it("are cut out of one decoded picture, each at a place of its own", async () => {
    const file = {};
    const whole = {};
    const made: unknown[][] = [];
    vi.stubGlobal("fetch", () => Promise.resolve({ blob: () => Promise.resolve(file) }));
    vi.stubGlobal("createImageBitmap", (...how: unknown[]) => {
      made.push(how);
      return Promise.resolve(how[0] === file ? whole : { how });
    });
    const portraits = await loadPortraits();
    expect(made[0]).toEqual([file]);
    expect(made.slice(1).every(([from]) => from === whole)).toBe(true);
    const places = made.slice(1).map(([, x, y]) => `${String(x)} ${String(y)}`);
    expect(new Set(places).size).toBe(names.length);
    const sizes = made.slice(1).map(([, , , width, height]) => ({ width, height }));
    expect(new Set(sizes.map((size) => JSON.stringify(size)))).toEqual(new Set([JSON.stringify(THUMBNAIL_SIZE)]));
    expect(portraits.map(([{ face, expression }]) => [face, expression])).toEqual(names);
  });
});
