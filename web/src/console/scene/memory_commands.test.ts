import { beforeEach, expect, it } from "vitest";
import type { FromClient, Manifest, State } from "../../link/messages";
import { ConsoleStore } from "../store/console_store";
import { MemoryCommands, pictureOf, placesOf } from "./memory_commands";

let sent: FromClient[];
let store: ConsoleStore;
let commands: MemoryCommands;

const show = (...memories: string[]): void => {
  const one = {
    ...{ presence: 1, panics: 0, regions: {}, channels: {}, layers: {}, motion: null, held: null },
    ...{ face_call: null, expression_call: null, home_face: "generic" },
  };
  store.receive({ type: "state", characters: { one, two: one }, memories } as unknown as State);
};
const taken = (): FromClient[] => {
  store.flush();
  return sent.splice(0);
};

beforeEach(() => {
  sent = [];
  store = new ConsoleStore(
    (message) => sent.push(message),
    () => 0,
    "a",
  );
  commands = new MemoryCommands(store);
  store.setOnline(true);
  show("2", "finale");
});

it("places on keys come first and keep their places", () => {
  expect(placesOf(["finale", "2"])).toEqual(["1", "2", "3", "4", "5", "6", "7", "8", "9", "finale"]);
});

it("a memory is called in the time of a face", () => {
  store.setTiming("face", { seconds: 4 });
  commands.press("finale", "call");
  expect(taken()).toMatchObject([{ type: "call_memory", name: "finale", seconds: 4 }]);
});

it("an empty place says how it is filled, and nothing is sent", () => {
  commands.press("1", "call");
  commands.press("1", "delete");
  expect(taken()).toEqual([]);
  expect(store.notice).toContain("Memory 1 is empty: press Keep, then 1");
});

it("what was kept or deleted is taken back and done again by its key", () => {
  commands.press("1", "keep");
  commands.press("2", "delete");
  const [keep, drop] = taken() as { key: string }[];
  expect([keep, drop]).toMatchObject([
    { type: "keep_memory", name: "1" },
    { type: "delete_memory", name: "2" },
  ]);
  store.undo();
  store.undo();
  expect(taken()).toMatchObject([
    { type: "restore_memory", key: drop?.key },
    { type: "restore_memory", key: keep?.key },
  ]);
  store.redo();
  expect(taken()).toMatchObject([{ type: "restore_memory", key: keep?.key }]);
});

it("a picture shows who is played, at the looks that show most, by their names in the cast", () => {
  expect(pictureOf(store, "2")).toBe(null);
  const [faces, expressions] = [[{ name: "old", source: "old" }], [{ name: "crooked", source: "crooked@3" }]] as const;
  store.setManifest({ faces, expressions, lights: [] } as unknown as Manifest);
  const goals = {
    "two/face": { dog: 1 },
    "one/face": { old: 0.6, kaori: 0.4 },
    "one/expression": { smile: 0.3, crooked: 0.7 },
  };
  store.receive({ type: "memory_list", memories: [{ name: "2", goals }] });
  expect(pictureOf(store, "2")).toEqual({ face: "old", expression: "crooked@3" });
  store.play(["two"]);
  expect(pictureOf(store, "2")).toEqual({ face: "dog", expression: "neutral" });
});
