import { describe, expect, it } from "vitest";
import type { Library } from "../../link/assets";
import { DraftStore } from "./draft_store";
import { keepViewSettings, readViewSettings, showsMuscles } from "./view_settings";

const cast = (...names: string[]): Library =>
  ({ manifest: { faces: names.map((name) => ({ name })) } }) as unknown as Library;
const store = (): DraftStore => new DraftStore(() => new Promise(() => undefined));

/** A browser's storage. */
function shelf(text: string | null = null): () => Pick<Storage, "getItem" | "setItem"> {
  let kept = text;
  const storage = {
    getItem: () => kept,
    setItem: (_: string, next: string) => {
      kept = next;
    },
  };
  return () => storage;
}

describe("the kept view", () => {
  it("is there again after a reload", () => {
    const storage = shelf();
    const before = store();
    keepViewSettings(before, storage);
    before.setCast(cast("kaori", "dog", "cat", "old"));
    before.setWork("dog");
    before.setNeighbours(["cat", "kaori"]);
    before.setOptions({ mirror: true });
    const after = store();
    keepViewSettings(after, storage);
    after.setCast(cast("kaori", "dog", "cat", "old"));
    expect([after.work, after.neighbours, after.options.mirror]).toEqual(["dog", ["cat", "kaori"], true]);
  });

  it("forgets faces that the cast has no more", () => {
    const one = store();
    keepViewSettings(one, shelf('{"work": "gone", "neighbours": ["gone", "dog", "kaori"]}'));
    one.setCast(cast("generic", "kaori", "dog"));
    expect([one.work, one.neighbours]).toEqual(["kaori", ["dog"]]);
  });

  it.each([null, "", "{", "null", "7", "[]", '{"work": 7, "neighbours": "dog", "mirror": "yes"}', '{"work": ""}'])(
    "begins anew where %s was kept",
    (text) => {
      const [one, fresh] = [store(), store()];
      keepViewSettings(one, shelf(text));
      expect([one.work, one.neighbours, one.options]).toEqual([fresh.work, fresh.neighbours, fresh.options]);
    },
  );

  it("takes of a list what are names", () => {
    expect(readViewSettings('{"neighbours": ["dog", 3, null, ""], "mirror": true}')).toEqual({
      neighbours: ["dog"],
      mirror: true,
    });
  });

  it("does without a storage that is shut off", () => {
    const one = store();
    const shut = (): never => {
      throw new Error("shut off");
    };
    keepViewSettings(one, shut);
    one.setCast(cast("kaori"));
    expect(one.work).toBe("kaori");
  });
});

it("shows muscles on expressions alone: on a face under work they would pull at nothing", () => {
  const { options } = store();
  const face = { kind: "face" } as unknown as DraftStore["face"];
  expect(showsMuscles({ options: { ...options, muscles: true }, face: null })).toBe(true);
  expect(showsMuscles({ options: { ...options, muscles: true }, face })).toBe(false);
  expect(showsMuscles({ options, face: null })).toBe(false);
});
