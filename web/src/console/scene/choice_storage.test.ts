import { describe, expect, it } from "vitest";
import { ConsoleStore } from "../store/console_store";
import { keepChoice, readChoice } from "./choice_storage";

const opened = () =>
  new ConsoleStore(
    () => undefined,
    () => 0,
    "a",
  );

describe("the choice of characters", () => {
  it("outlives a reload of the page", () => {
    const kept = new Map<string, string>();
    const tab = () => ({ getItem: (key: string) => kept.get(key) ?? null, setItem: kept.set.bind(kept) as never });
    const before = opened();
    keepChoice(before, tab);
    before.play(["two", "one"]);
    const after = opened();
    keepChoice(after, tab);
    expect(after.played.chosen).toEqual(["two", "one"]);
  });

  it("is the first character where the tab keeps nothing, or something else", () => {
    for (const document of ["", "3", "null", "[]", "[1]", '{"a":1}']) expect(readChoice(document)).toBeNull();
    const store = opened();
    keepChoice(store, () => {
      throw new Error("forbidden");
    });
    store.play(["two"]);
    expect(store.played.chosen).toEqual(["two"]);
  });
});
