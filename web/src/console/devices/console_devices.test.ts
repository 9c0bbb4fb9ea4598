import { expect, it } from "vitest";
import type { BindingDocument, FromClient } from "../../link/messages";
import { ConsoleStore } from "../store/console_store";
import { FIRST_BINDING } from "./binding_fields";
import { channelTarget } from "./binding_target";
import type { Browser } from "./browser_devices";
import { ConsoleDevices, stepOf } from "./console_devices";

/** A browser that has no devices. */
const browser: Browser = {
  secure: true,
  store: () => ({ getItem: () => null, setItem: () => undefined }),
  requestMidi: null,
  gamepads: null,
  hid: null,
  now: () => 0,
  later: (call) => call(),
};

function devices() {
  const sent: FromClient[] = [];
  const send = (message: FromClient): unknown => sent.push(message);
  const store = new ConsoleStore(send, () => 0, "page");
  const consoleDevices = new ConsoleDevices(store, send, browser);
  store.setOnline(true);
  const said = (): string[] => store.logEntries.map(({ text }) => text);
  return { store, sent, consoleDevices, said };
}

const binding = (control: string): BindingDocument => ({
  ...FIRST_BINDING,
  device: "Dial",
  control,
  to: "/omote/one/channel/jawOpen",
});
/** Of changes that a page has asked for. */
const ASKED = { preset: "", here: true };
const idOf = (message: FromClient | undefined): string => (message as { id: string }).id;

it("offers to take back what it has bound, once the show has done it", () => {
  const { store, sent, consoleDevices, said } = devices();
  consoleDevices.bind(binding("1/cc7"));
  expect(store.history.next("undo")).toBeNull();
  store.receive({ type: "bindings_changed", id: "somebody else's", added: [binding("1/cc8")], removed: [], ...ASKED });
  store.receive({ type: "bindings_changed", id: idOf(sent[0]), added: [binding("1/cc7")], removed: [], ...ASKED });
  expect(said()).toEqual(["Bound: Dial 1/cc7 plays jawOpen."]);
  expect(store.history.next("undo")?.undo).toEqual([{ type: "unbind", binding: binding("1/cc7") }]);
});

it("says that a preset was loaded by itself, and offers to take it back where the device is", () => {
  const { store, said } = devices();
  const change = { type: "bindings_changed", id: "preset Dial", added: [binding("1/cc7")], removed: [] } as const;
  const [added, removed] = [[...change.added], []];
  store.receive({ ...change, added, removed, preset: "A desk", here: false });
  expect(said()).toEqual(["Dial plays as A desk, the preset that is made for it."]);
  expect(store.history.next("undo")).toBeNull();
  store.receive({ ...change, added, removed, preset: "A desk", here: true });
  expect(store.history.next("undo")?.undo).toEqual([{ type: "unbind", binding: binding("1/cc7") }]);
});

it("knows why a binding waits", () => {
  const { store, consoleDevices } = devices();
  const bindings = [binding("1/cc7"), binding("1/cc8")];
  const missing = ["there is no character 'one'", ""];
  store.receive({ type: "binding_list", bindings, fixed: [], presets: [], learning: null, missing });
  expect(consoleDevices.bindings.map((listed) => consoleDevices.whyMissing(listed))).toEqual(missing);
});

it("says that a device that plays something was unplugged, and that it is back", () => {
  const { store, said } = devices();
  store.receive({
    type: "binding_list",
    bindings: [binding("1/cc7")],
    fixed: [],
    presets: [],
    learning: null,
    missing: [],
  });
  const list = (...plugged: [string, boolean][]): void =>
    store.receive({ type: "devices", devices: plugged.map(([name, on]) => ({ name, plugged: on })) } as never);
  list(["Dial", false], ["Other", true]);
  expect(said()).toEqual([]);
  list(["Dial", true], ["Other", true]);
  list(["Dial", false], ["Other", false]);
  list(["Dial", false]);
  expect(said()).toEqual(["Dial is unplugged: what it played stays as it is."]);
  list(["Dial", true]);
  expect(said()).toHaveLength(2);
});

it("names what it has learned, and stops to learn", () => {
  const { store, sent, consoleDevices, said } = devices();
  const target = channelTarget("one", "jawOpen");
  consoleDevices.learn(target);
  expect(sent[0]).toMatchObject({ type: "learn", to: "/omote/one/channel/jawOpen", axis: "", arguments: [], bank: "" });
  consoleDevices.stopLearning(); // the show has not said that it learns
  const learning = { id: "a", who: "Left", ...target };
  store.receive({ type: "binding_list", bindings: [], fixed: [], presets: [], learning, missing: [] });
  store.receive({ type: "bindings_changed", id: idOf(sent[0]), added: [binding("1/cc7")], removed: [], ...ASKED });
  consoleDevices.stopLearning();
  expect(said()).toEqual(["Bound: Dial 1/cc7 plays jawOpen."]);
  expect(sent.slice(1)).toMatchObject([{ type: "learn", to: "" }]);
});

it("says why something was rejected, and that nothing goes over a lost link", () => {
  const { store, sent, consoleDevices, said } = devices();
  consoleDevices.unbind(binding("1/cc7"));
  store.receive({ type: "refused", reason: "No such binding.", id: idOf(sent[0]), held: [] });
  store.setOnline(false);
  consoleDevices.unbind(binding("1/cc7"));
  consoleDevices.chooseBank("Dial", "a");
  expect([said().length, sent.length, said()[0]]).toEqual([3, 1, "No such binding."]);
});

it("asks again to be told when the link is back", () => {
  const { store, sent, consoleDevices } = devices();
  consoleDevices.watch(true);
  store.setOnline(false);
  store.setOnline(true);
  consoleDevices.watch(false);
  expect(sent.map((message) => message.type === "watch_devices" && message.on)).toEqual([true, true, false]);
});

it("knows what can be switched, and says why something was not", () => {
  const { store, sent, consoleDevices, said } = devices();
  const way = { name: "vmc", title: "VMC", port: 39539 };
  store.receive({
    type: "devices",
    devices: [],
    trackers: [],
    found: [],
    receivers: [],
    ways: [way],
    phone_page: "/connect",
    host: "192.168.1.20",
  });
  expect([consoleDevices.ways, consoleDevices.phonePage, consoleDevices.machine]).toEqual([
    [way],
    "/connect",
    "192.168.1.20",
  ]);
  consoleDevices.switchDevice("listen", "vmc:39539", true);
  expect(sent[0]).toMatchObject({ type: "switch_device", direction: "listen", word: "vmc:39539", on: true });
  store.receive({ type: "refused", reason: "port 39539 cannot be opened.", id: idOf(sent[0]), held: [] });
  expect(said()).toEqual(["port 39539 cannot be opened."]);
});

it("makes of each change one that takes it back, and one that does it again", () => {
  const [old, one, other] = [binding("a"), binding("b"), binding("c")];
  const edited = stepOf("edit", [one], [old]);
  expect(edited.undo).toEqual([{ type: "bind", binding: old, replaces: one }]);
  expect(edited.redo).toEqual([{ type: "bind", binding: one, replaces: old }]);
  const loaded = stepOf("preset", [one, other], [old]);
  expect(loaded.undo.map(({ type }) => type)).toEqual(["unbind", "unbind", "bind"]);
  expect(loaded.redo.map(({ type }) => type)).toEqual(["unbind", "bind", "bind"]);
});
