import { beforeEach, describe, expect, it } from "vitest";
import { LAYER_PARTS, ROUTE_PARTS } from "../../link/constants";
import type { CharacterState, FromClient, LayerState, SourceState, State } from "../../link/messages";
import { ConsoleStore } from "../store/console_store";
import { LayerCommands, withCharacter, withPart } from "./layer_commands";

const SET: LayerState = {
  influence: [1, 0.5, 0.2, 0, 1, 1],
  on: false,
  trust: 1,
  source: "phone",
  share: 1,
  strongest: {},
  sources: [],
};
const character = (layers: CharacterState["layers"]): CharacterState =>
  ({
    label: "One",
    presence: 1,
    panics: 0,
    face_call: null,
    expression_call: null,
    home_face: "generic",
    regions: {},
    channels: {},
    held: null,
    layers,
  }) as never;
const SOURCE: SourceState = {
  name: "phone",
  kind: "tracker",
  console: "",
  characters: ["one"],
  layer: "tracker",
  regions: ["mouth"],
  performer: "phone",
  rate: 30,
  found: true,
  body: false,
  calibrated: false,
  ranging: false,
  mirror: false,
  dead_zone: 0.1,
  smoothing: 0.5,
  curve: 0,
  gain: 1,
  lids: 1,
  neutral: {},
  highest: {},
};

let sent: FromClient[];
let store: ConsoleStore;
let commands: LayerCommands;

beforeEach(() => {
  sent = [];
  store = new ConsoleStore(
    (message) => sent.push(message),
    () => 0,
    "a",
  );
  commands = new LayerCommands(store);
  store.setOnline(true);
  store.receive({
    type: "state",
    characters: { one: character({ tracker: SET }), two: character({}) },
  } as unknown as State);
  store.play(["one", "two"]);
});

/** What was sent, without the ids. */
function said(): unknown[] {
  store.flush();
  return sent.splice(0).map((message) => ({ ...message, id: undefined }));
}

describe("a layer", () => {
  const layer = (name: string, change: object) => ({
    type: "set_layer",
    character: name,
    layer: "tracker",
    id: undefined,
    ...change,
  });

  it("is switched as the first one played is not, and taken back to what each was", () => {
    commands.switch("tracker");
    expect(said()).toEqual([layer("one", { on: true }), layer("two", { on: true })]);
    store.undo();
    expect(said()).toEqual([layer("one", { on: false }), layer("two", { on: true })]);
    store.redo();
    expect(said()).toEqual([layer("one", { on: true }), layer("two", { on: true })]);
  });

  it("shows again as at first in every part, and as before once that is taken back", () => {
    store.play(["one"]);
    commands.reset("tracker");
    expect(said()).toEqual(LAYER_PARTS.map((region) => layer("one", { region, influence: 1 })));
    store.undo();
    expect(said()).toEqual(LAYER_PARTS.map((region, at) => layer("one", { region, influence: SET.influence[at] })));
  });

  it("is faded on the whole and by part, one message a frame", () => {
    store.play(["one"]);
    for (const value of [0.8, 0.4]) store.layer("tracker", null).grip(value);
    store.layer("tracker", "mouth").nudge(0.6);
    expect(said()).toEqual([
      layer("one", { region: null, influence: 0.4 }),
      layer("one", { region: "mouth", influence: 0.6 }),
    ]);
    expect(store.layer("tracker", "mouth").control).toBe("set_layer:tracker:mouth");
    store.receive({ type: "hands", hands: { "one/set_layer:tracker": "Ben" } });
    expect(store.otherOn(store.layer("tracker", null))).toBe("Ben");
  });
});

describe("what moves by itself", () => {
  it("is set one detail at a time, of each that is played; all else stays", () => {
    const unset = {
      character: "*",
      type: "set_motion",
    };
    store.motion("liveliness").grip(0.2);
    store.motion("liveliness").grip(0.5);
    store.motion("gaze").nudge(1.5);
    expect(said()).toEqual([
      { ...unset, liveliness: 0.5, id: undefined },
      { ...unset, gaze: 1.5, id: undefined },
    ]);
    expect(store.motion("blinks").value(0)).toBe(1);
    expect(store.motion("blinks").control).toBe("set_motion");
  });
});

describe("a source", () => {
  const route = { type: "route_source", source: "phone", characters: ["one"], layer: "tracker", regions: ["mouth"] };
  const tuning = {
    type: "tune_source",
    source: "phone",
    mirror: false,
    dead_zone: 0.1,
    curve: 0,
    gain: 1,
    smoothing: 0.5,
    lids: 1,
  };

  it("is routed elsewhere in the same parts, and back", () => {
    commands.route(SOURCE, { characters: ["one", "two"] });
    expect(said()).toEqual([{ ...route, characters: ["one", "two"] }]);
    store.undo();
    expect(said()).toEqual([route]);
    commands.route(SOURCE, { layer: "playback" });
    expect(said()).toEqual([{ ...route, layer: "playback" }]);
  });

  it("is tuned in one thing alone, and back", () => {
    commands.tune(SOURCE, { mirror: true });
    expect(said()).toEqual([{ ...tuning, mirror: true }]);
    store.undo();
    expect(said()).toEqual([tuning]);
  });

  it("plays other parts, and back", () => {
    commands.route(SOURCE, { regions: withPart(SOURCE.regions, "brows") });
    expect(said()).toEqual([{ ...route, regions: ["brows", "mouth"] }]);
    expect(store.notice).toBe("phone plays brows, mouth now.");
    store.undo();
    expect(said()).toEqual([route]);
  });
});

it("a press on a part takes it alone of all, else into a route or out of it; where none is left all are in it", () => {
  expect(withPart([...ROUTE_PARTS], "mouth")).toEqual(["mouth"]);
  expect(withPart(["mouth"], "brows")).toEqual(["brows", "mouth"]);
  expect(withPart(["mouth", "brows"], "mouth")).toEqual(["brows"]);
  expect(withPart(["mouth"], "mouth")).toEqual([...ROUTE_PARTS]);
});

it("a press on a character takes it into a route, or out of it, also of all", () => {
  expect(withCharacter(["one"], "two", ["one", "two"])).toEqual(["one", "two"]);
  expect(withCharacter(["*"], "two", ["one", "two"])).toEqual(["one"]);
  expect(withCharacter(["one"], "one", ["one", "two"])).toEqual([]);
});
