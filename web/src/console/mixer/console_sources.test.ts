import { beforeEach, expect, test } from "vitest";
import type { FromClient, SourceState, SourceValues, State } from "../../link/messages";
import { ConsoleStore } from "../store/console_store";
import { ConsoleSources } from "./console_sources";

const source = (change: Partial<SourceState> = {}): SourceState =>
  ({
    name: "phone",
    kind: "tracker",
    characters: ["one"],
    layer: "tracker",
    regions: ["mouth"],
    neutral: {},
    highest: {},
    ...change,
  }) as never;

let sent: FromClient[];
let store: ConsoleStore;
let sources: ConsoleSources;

beforeEach(() => {
  sent = [];
  store = new ConsoleStore(
    (message) => sent.push(message),
    () => 0,
    "a",
  );
  sources = new ConsoleSources(store, (message) => sent.push(message));
  store.setOnline(true);
  store.receive({
    type: "state",
    characters: {
      one: {
        label: "One",
        layers: {},
        panics: 0,
        face_call: null,
        expression_call: null,
        home_face: "generic",
        regions: {},
        channels: {},
        held: null,
      },
    },
  } as unknown as State);
});

function said(): unknown[] {
  store.flush();
  return sent.splice(0).map((message) => ({ ...message, id: undefined }));
}

test("a measure is taken back and done again, by what it found", () => {
  store.receive({ type: "sources", sources: [source()] });
  sources.calibrate(source(), "neutral");
  expect(said()).toMatchObject([{ type: "calibrate_source", source: "phone", step: "neutral", channels: [] }]);
  store.receive({ type: "sources", sources: [source({ neutral: { jawOpen: 0.1 } })] });
  store.undo();
  expect(said()).toMatchObject([{ type: "measure_source", neutral: {}, highest: {} }]);
  store.redo();
  expect(said()).toMatchObject([{ type: "measure_source", neutral: { jawOpen: 0.1 }, highest: {} }]);
});

test("a source that plays nobody is routed by its question, and back", () => {
  store.receive({ type: "sources", sources: [source({ characters: [] })] });
  const [offer] = sources.question?.offers ?? [];
  if (offer && "act" in offer) offer.act();
  const route = { type: "route_source", source: "phone", layer: "tracker", regions: ["mouth"] };
  expect(said()).toMatchObject([{ ...route, characters: ["one"] }]);
  expect(store.notice).toBe("phone plays One.");
  store.undo();
  expect(said()).toMatchObject([{ ...route, characters: [] }]);
});

test("values of the source that is watched are read, those of another are not", () => {
  const bytes = new Uint8Array(new Float32Array([0.5]).buffer);
  const values: SourceValues = {
    type: "source_values",
    source: "phone",
    names: ["jawOpen"],
    sent: bytes,
    weights: bytes,
  };
  store.receive(values);
  expect(sources.watched).toBeNull();
  sources.watch("phone");
  expect(said()).toMatchObject([{ type: "watch_source", source: "phone" }]);
  store.receive(values);
  expect([...(sources.watched?.sent ?? [])]).toEqual([0.5]);
  sources.watch("");
  expect(sources.watched).toBeNull();
});
