import { beforeEach, expect, it } from "vitest";
import type { FromClient, State } from "../../link/messages";
import { ConsoleStore } from "./console_store";
import { PanicReturn } from "./panic_return";

const REX = {
  label: "Rex",
  presence: 1,
  panics: 0,
  faces: { dog: 1 },
  face_call: null,
  expression_call: null,
  home_face: "generic",
  home_next: false,
  regions: {},
  channels: {},
  held: null,
  layers: { tracker: { on: true, source: "Mira" }, lips: { on: false, source: "Mira" } },
  motion: { liveliness: 0.4 },
};
const OFF = { ...REX.layers, tracker: { on: false, source: "Mira" } };
const ONCE = { panics: 1, home_next: true, layers: OFF, motion: { liveliness: 0 } };
const TWICE = { ...ONCE, panics: 2, home_next: false };

let sent: FromClient[];
let store: ConsoleStore;
let returns: PanicReturn;

beforeEach(() => {
  sent = [];
  store = new ConsoleStore(
    (message) => sent.push(message),
    () => 0,
    "a",
  );
  returns = new PanicReturn(store);
  store.setOnline(true);
  hear({});
  store.play(["rex"]);
});

/** A newer state, where Rex and Ana are as at first but for these. */
function hear(change: object, other: object = {}): void {
  const state = { type: "state", characters: { rex: { ...REX, ...change }, ana: { ...REX, label: "Ana", ...other } } };
  store.receive(state as unknown as State);
}

const offered = (): string[] => returns.question?.offers.map(({ label }) => label) ?? [];
function press(label: string): unknown[] {
  const offer = returns.question?.offers.find((candidate) => candidate.label === label);
  if (offer !== undefined && "act" in offer) offer.act();
  return said();
}
function said(): unknown[] {
  store.flush();
  return sent.splice(0);
}

it("a panic that ends sources offers them again, with the liveliness of before, and that is undone", () => {
  hear(ONCE);
  expect(offered()).toEqual(["Sources on again"]);
  expect(store.logEntries.at(-1)?.text).toBe("Stopped by panic: sources and liveliness of Rex.");
  const [tracker, motion, ...others] = press("Sources on again");
  expect(tracker).toMatchObject({ type: "set_layer", character: "rex", layer: "tracker", on: true });
  expect(motion).toMatchObject({ type: "set_motion", character: "rex", liveliness: 0.4 });
  expect(others).toEqual([]);
  expect(returns.question).toBeNull();
  store.undo();
  expect(said()).toMatchObject([{ layer: "tracker", on: false }, { liveliness: 0 }]);
});

it("says what has ended, and nothing else", () => {
  hear({ ...ONCE, layers: REX.layers });
  expect(returns.question?.text).toBe("Stopped by panic: liveliness of Rex.");
});

it("a second panic offers the face of before, called in the usual seconds", () => {
  store.setTiming("face", { seconds: 4 });
  hear(ONCE);
  hear(TWICE);
  expect(offered()).toEqual(["Sources on again", "Faces of before"]);
  expect(press("Faces of before")).toMatchObject([{ type: "call_face", character: "rex", name: "dog", seconds: 4 }]);
  expect(offered()).toEqual(["Sources on again"]);
  expect(store.logEntries.map(({ text }) => text)).toContain("Home face: Rex.");
});

it("what somebody has brought back, or cast anew, is offered no more", () => {
  hear(ONCE);
  hear({ ...ONCE, layers: REX.layers, motion: REX.motion });
  expect(offered()).toEqual([]);
  hear(ONCE);
  hear(TWICE);
  expect(offered()).toEqual(["Faces of before"]);
  hear({ ...TWICE, face_call: { target: "cat" } });
  expect(returns.question).toBeNull();
});

it("a panic of all is offered to be taken back of all", () => {
  hear(ONCE, ONCE);
  hear(TWICE, TWICE);
  expect(press("Faces of before")).toMatchObject([{ character: "rex" }, { character: "ana" }]);
  expect(press("Sources on again").length).toBe(4);
});

it("nothing is offered where nothing ended, for characters played elsewhere, or once it is dismissed", () => {
  hear({ panics: 1 });
  expect(returns.question).toBeNull();
  hear({ panics: 1 }, ONCE);
  expect(returns.question).toBeNull();
  hear({ ...ONCE, panics: 2 });
  returns.question?.dismiss();
  expect(returns.question).toBeNull();
});
