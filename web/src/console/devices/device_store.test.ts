import { expect, it } from "vitest";
import type { BindingDocument, FromClient } from "../../link/messages";
import { TopicStore } from "../../link/topics";
import type { Step } from "../store/undo_history";
import { FIRST_BINDING } from "./binding_fields";
import { channelTarget } from "./binding_target";
import { DeviceStore, stepOf } from "./device_store";

class Host extends TopicStore<"link"> {
  online = true;
  said: string[] = [];
  steps: [string, Step][] = [];

  label(_: string, name: string): string {
    return name;
  }

  say(notice: string): void {
    this.said.push(notice);
  }

  offerUndo(done: string, step: Step): void {
    this.steps.push([done, step]);
  }
}

function store() {
  const [host, sent] = [new Host(), [] as FromClient[]];
  return { host, sent, made: new DeviceStore(host, (message) => sent.push(message), "page") };
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
  const { host, sent, made } = store();
  made.bind(binding("1/cc7"));
  expect(host.steps).toEqual([]);
  made.receive({ type: "bindings_changed", id: "somebody else's", added: [binding("1/cc8")], removed: [], ...ASKED });
  made.receive({ type: "bindings_changed", id: idOf(sent[0]), added: [binding("1/cc7")], removed: [], ...ASKED });
  expect(host.steps.map(([done]) => done)).toEqual(["Bound: Dial 1/cc7 plays jawOpen."]);
  expect(host.steps[0]?.[1].undo).toEqual([{ type: "unbind", binding: binding("1/cc7") }]);
});

it("says that a preset was loaded by itself, and offers to take it back where the device is", () => {
  const { host, made } = store();
  const change = { type: "bindings_changed", id: "preset Dial", added: [binding("1/cc7")], removed: [] } as const;
  const [added, removed] = [[...change.added], []];
  made.receive({ ...change, added, removed, preset: "A desk", here: false });
  expect([host.said, host.steps]).toEqual([["Dial plays as A desk, the preset that is made for it."], []]);
  made.receive({ ...change, added, removed, preset: "A desk", here: true });
  expect(host.steps.map(([done, { undo }]) => [done, undo])).toEqual([
    ["Dial plays as A desk, the preset that is made for it.", [{ type: "unbind", binding: binding("1/cc7") }]],
  ]);
});

it("knows why a binding waits", () => {
  const { made } = store();
  const bindings = [binding("1/cc7"), binding("1/cc8")];
  const missing = ["there is no character 'one'", ""];
  made.receive({ type: "binding_list", bindings, fixed: [], presets: [], learning: null, missing });
  expect(made.bindings.map((one) => made.whyMissing(one))).toEqual(missing);
});

it("names what it has learned, and stops to learn", () => {
  const { host, sent, made } = store();
  const target = channelTarget("one", "jawOpen");
  made.learn(target);
  expect(sent[0]).toMatchObject({ type: "learn", to: "/omote/one/channel/jawOpen", axis: "", arguments: [], bank: "" });
  made.stopLearning(); // the show has not said that it learns
  const learning = { id: "a", who: "Left", ...target };
  made.receive({ type: "binding_list", bindings: [], fixed: [], presets: [], learning, missing: [] });
  made.receive({ type: "bindings_changed", id: idOf(sent[0]), added: [binding("1/cc7")], removed: [], ...ASKED });
  made.stopLearning();
  expect(host.steps.map(([done]) => done)).toEqual(["Bound: Dial 1/cc7 plays jawOpen."]);
  expect(sent.slice(1)).toMatchObject([{ type: "learn", to: "" }]);
});

it("says why something was rejected, and that nothing goes over a lost link", () => {
  const { host, sent, made } = store();
  made.unbind(binding("1/cc7"));
  expect(made.receiveRefused("No such binding.", "another")).toBe(false);
  expect(made.receiveRefused("No such binding.", idOf(sent[0]))).toBe(true);
  host.online = false;
  made.unbind(binding("1/cc7"));
  made.chooseBank("Dial", "a");
  expect([host.said.length, sent.length, host.said[0]]).toEqual([3, 1, "No such binding."]);
});

it("asks again to be told when the link is back", () => {
  const { host, sent, made } = store();
  made.watch(true);
  host.online = false;
  made.setOnline(false);
  host.online = true;
  made.setOnline(true);
  made.watch(false);
  expect(sent.map((message) => message.type === "watch_devices" && message.on)).toEqual([true, true, false]);
});

it("knows what can be switched, and says why something was not", () => {
  const { host, sent, made } = store();
  const way = { name: "vmc", title: "VMC", port: 39539 };
  made.receive({
    type: "devices",
    devices: [],
    trackers: [],
    found: [],
    receivers: [],
    ways: [way],
    phone_page: "/connect",
    host: "192.168.1.20",
  });
  expect([made.ways, made.phonePage, made.machine]).toEqual([[way], "/connect", "192.168.1.20"]);
  made.switchDevice("listen", "vmc:39539", true);
  expect(sent[0]).toMatchObject({ type: "switch_device", direction: "listen", word: "vmc:39539", on: true });
  expect(made.receiveRefused("port 39539 cannot be opened.", idOf(sent[0]))).toBe(true);
  expect(host.said).toEqual(["port 39539 cannot be opened."]);
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
