import { expect, it } from "vitest";
import type { ItemDocument } from "../../link/editing_messages";
import type { DraftStore } from "./draft_store";
import { freeLabel, othersOf, weighed } from "./item_commands";

it("counts oneself among those at an item once, whoever bears the same name", () => {
  expect(othersOf(["Ann", "Ben"], "Ann")).toEqual(["Ben"]);
  expect(othersOf(["Ann", "Ann"], "Ann")).toEqual(["Ann"]);
  expect(othersOf(["Ben"], "Ann")).toEqual(["Ben"]);
});

it("names something new as nothing of its kind is called, built in or own, but what was deleted", () => {
  const items = [
    { kind: "face", label: "Ann", deleted: false },
    { kind: "face", label: "Bo", deleted: true },
    { kind: "expression", label: "Cry", deleted: false },
  ] as ItemDocument[];
  const manifest = {
    faces: [{ label: "Dog" }],
    expressions: [{ label: "Smile" }],
  } as unknown as DraftStore["manifest"];
  const named = (stem: string): string => freeLabel({ items, manifest }, "face", stem);
  expect(["ann", "Bo", "Cry", "dog", "Smile"].map(named)).toEqual(["ann 2", "Bo", "Cry", "dog 2", "Smile"]);
  expect(freeLabel({ items, manifest: null }, "face", "Dog")).toBe("Dog");
});

it("gives one of a mix the weight that was typed, and shares the rest as before", () => {
  expect(weighed({ a: 0.5, b: 0.5 }, "a", 0.3)).toEqual({ a: 0.3, b: 0.7 });
  const three = weighed({ a: 0.2, b: 0.6, c: 0.2 }, "c", 0.6);
  expect(three.a).toBeCloseTo(0.1);
  expect(three.b).toBeCloseTo(0.3);
  expect(three.c).toBe(0.6);
  expect(Object.keys(three)).toEqual(["a", "b", "c"]);
  expect(weighed({ a: 1, b: 0 }, "a", 0.25)).toEqual({ a: 0.25, b: 0.75 });
  expect(weighed({ a: 1, b: 0 }, "b", 7)).toEqual({ a: 0, b: 1 });
  expect(weighed({ a: 1 }, "a", 0.3)).toEqual({ a: 1 });
});
