import { beforeEach, expect, it } from "vitest";
import type { FromClient, State } from "../../link/messages";
import { ConsoleStore } from "./console_store";
import { isStill, toggleStill } from "./stillness";

const character = (liveliness: number) => ({
  ...{ presence: 1, panics: 0, regions: {}, channels: {}, layers: {}, motion: { liveliness } },
  ...{ face_call: null, expression_call: null, home_face: "generic", held: null },
});

let sent: FromClient[];
let store: ConsoleStore;

const show = (one: number, two: number): void =>
  store.receive({ type: "state", characters: { one: character(one), two: character(two) } } as unknown as State);
const liveliness = (): unknown[] =>
  sent.splice(0).map((message) => (message.type === "set_motion" ? [message.character, message.liveliness] : message));

beforeEach(() => {
  sent = [];
  store = new ConsoleStore(
    (message) => sent.push(message),
    () => 0,
    "a",
  );
  store.setOnline(true);
});

it("one press holds those still that are played, Undo moves them as before", () => {
  show(0.3, 0);
  store.play(["one", "two"]);
  toggleStill(store);
  store.flush();
  expect(liveliness()).toEqual([
    ["one", 0],
    ["two", 0],
  ]);
  store.undo();
  store.flush();
  expect(liveliness()).toEqual([
    ["one", 0.3],
    ["two", 0],
  ]);
});

it("a press where they are still moves them as people do, and leaves others alone", () => {
  show(0, 0.7);
  store.play(["one"]);
  expect(isStill(store)).toBe(true);
  toggleStill(store);
  store.flush();
  expect(liveliness()).toEqual([["one", 0.5]]);
});
