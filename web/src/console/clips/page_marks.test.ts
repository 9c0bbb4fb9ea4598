import { describe, expect, it } from "vitest";
import { PageMarks } from "./page_marks";

function storage() {
  const kept = new Map<string, string>();
  return () => ({
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, text: string) => void kept.set(key, text),
  });
}

const MARKS = { clip: "line", lane: 1, armed: ["brows" as const], countsIn: false, passSpeed: 0.5, character: "one" };

describe("the marks of a page of clips", () => {
  it("outlive a reload, and another tab begins with the same", () => {
    const [browser, tab] = [storage(), storage()];
    expect(new PageMarks(browser, tab).read()).toEqual({});
    new PageMarks(browser, tab).write(MARKS);
    new PageMarks(browser, storage()).write({ ...MARKS, lane: 2 });
    expect(new PageMarks(browser, tab).read()).toEqual(MARKS);
    expect(new PageMarks(browser, storage()).read()).toEqual({ ...MARKS, lane: 2 });
  });

  it("are left out where they cannot be read", () => {
    const tab = storage();
    tab().setItem(
      "omote clips",
      '{"clip": 3, "lane": -1, "armed": ["nose", "head"], "countsIn": "no", "passSpeed": 3}',
    );
    expect(new PageMarks(storage(), tab).read()).toEqual({ armed: ["head"] });
  });
});
