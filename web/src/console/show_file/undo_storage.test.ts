import { describe, expect, it } from "vitest";
import type { Bus } from "../../link/bus";
import type { FromClient, Welcome } from "../../link/messages";
import { ConsoleStore } from "../store/console_store";
import { OwnItems } from "./own_items";
import { keepUndo, readSteps } from "./undo_storage";

const GRIN = { kind: "expression", name: "grin", label: "Grin" } as const;

/** A console page in a tab that keeps `kept`, and all that it sends. */
const welcomeTo = (show: string): Welcome =>
  ({ type: "welcome", version: 7, epoch: 1, revision: 1, digest: "", name: "", show }) as const;

function open(kept: Map<string, string>, show = "first", bus: Bus = "air") {
  const sent: FromClient[] = [];
  const store = new ConsoleStore(
    (message) => sent.push(message),
    () => 0,
    "me",
  );
  store.bus = bus;
  keepUndo(store, () => ({
    getItem: (key) => kept.get(key) ?? null,
    setItem: (key, text) => void kept.set(key, text),
  }));
  store.receive(welcomeTo(show));
  store.setOnline(true);
  const types = (): string[] => sent.splice(0).map(({ type }) => type);
  return { store, items: new OwnItems(store, () => 0), types };
}

describe("the steps of a console", () => {
  it("are taken back and done again after a reload, in their order, as often as the page is reloaded", () => {
    const kept = new Map<string, string>();
    const first = open(kept);
    first.store.offerUndo("", first.items.stepOf("take in grin", [GRIN]));
    first.store.offerUndo("", { what: "save", undo: [{ type: "drop_layout", name: "a" }], redo: [] });
    first.store.offerUndo("", { what: "look", undo: [{ type: "look_at", character: "one", kind: "ahead" }], redo: [] });
    const second = open(kept);
    expect(second.store.history.steps).toEqual(first.store.history.steps);
    expect(open(kept, "first", "preview").store.history.steps).toEqual({ undo: [], redo: [] });
    for (let count = 0; count < 3; count += 1) second.store.undo();
    expect(second.types()).toEqual(["look_at", "drop_layout", "delete_item"]);
    const third = open(kept);
    expect(third.store.history.next("undo")).toBeNull();
    third.store.redo();
    expect(third.types()).toEqual(["restore_item"]);
    expect(third.store.history.next("undo")?.what).toBe("take in grin");
  });

  it("take nothing away when they are done again after a reload, and nothing beyond that", () => {
    const kept = new Map<string, string>();
    const first = open(kept);
    const step = (what: string, redo: "remove_character" | "restore_character"): void => {
      const back = { type: "restore_character", key: what, seconds: 1 } as const;
      const away = { type: "remove_character", character: "two", key: what, seconds: 1 } as const;
      const [done, undone] = redo === "remove_character" ? [away, back] : [back, away];
      first.store.offerUndo("", { what, undo: [undone], redo: [done] });
    };
    step("add one", "restore_character");
    step("remove two", "remove_character");
    step("add two", "restore_character");
    for (let count = 0; count < 3; count += 1) first.store.undo();
    expect(first.store.history.next("redo")?.what).toBe("add one");
    const second = open(kept);
    second.store.redo();
    expect(second.types()).toEqual(["restore_character"]);
    expect(second.store.history.next("redo")).toBeNull();
    second.store.redo();
    expect(second.types()).toEqual([]);
  });

  it("stay with their tab: another begins with none", () => {
    const first = open(new Map());
    first.store.offerUndo("", first.items.stepOf("take in grin", [GRIN]));
    expect(open(new Map()).store.history.next("undo")).toBeNull();
  });

  it("are forgotten where another show is served at the address, in a page that stays open too", () => {
    const kept = new Map<string, string>();
    const first = open(kept);
    first.store.offerUndo("", first.items.stepOf("take in grin", [GRIN]));
    const other = open(new Map(kept), "second");
    expect(other.store.history.next("undo")).toBeNull();
    first.store.receive(welcomeTo("first")); // the link came back
    expect(first.store.history.next("undo")?.what).toBe("take in grin");
    first.store.receive(welcomeTo("second"));
    expect(first.store.history.next("undo")).toBeNull();
    expect(open(kept, "first").store.history.next("undo")).toBeNull();
  });

  it("that a tab cannot keep last as long as the page", () => {
    const { store } = open(new Map());
    const forbid = (): never => {
      throw new Error("forbidden");
    };
    keepUndo(store, forbid);
    keepUndo(store, () => ({ getItem: () => null, setItem: forbid }));
    store.history.add({ what: "keep", undo: [], redo: [] });
    expect(store.history.next("undo")?.what).toBe("keep");
  });

  it("are left alone where something else lies in their place", () => {
    const step = { what: "keep", undo: [{ type: "delete_item" }], redo: [] };
    const document = { version: 2, show: "first", undo: [step], redo: [] };
    const written = (change: object): string => JSON.stringify({ ...document, ...change });
    expect(readSteps(written({}))).toEqual({ show: "first", steps: { undo: [step], redo: [] } });
    const wrong = [
      { version: 1 },
      { show: "" },
      { show: 1 },
      { redo: {} },
      { undo: [3] },
      { undo: [{ ...step, what: 1 }] },
      { undo: [{ ...step, undo: [{ character: "one" }] }] },
      { undo: [{ ...step, panics: "1" }] },
    ];
    for (const document of ["", "3", "null", "[]", ...wrong.map(written)]) expect(readSteps(document)).toBeNull();
  });
});
