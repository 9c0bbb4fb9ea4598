import { beforeEach, describe, expect, it } from "vitest";
import type { CharacterState, FromClient, State } from "../../link/messages";
import { nameOf } from "../store/character_names";
import { ConsoleStore } from "../store/console_store";
import { SceneCommands } from "./scene_commands";

const REST = {
  faces: { generic: 0.25, old: 0.75 },
  channels: {},
  face_call: null,
  expression_call: null,
  leaves: false,
  regions: {},
  region_calls: {},
  layers: {},
  held: null,
  panics: 0,
  home_face: "generic",
};
const character = (label: string, presence = 1): CharacterState => ({ ...REST, label, presence }) as never;
const stateOf = (...labels: string[]): State =>
  ({
    type: "state",
    characters: Object.fromEntries(labels.map((label) => [nameOf(label, []), character(label)])),
  }) as unknown as State;

let sent: FromClient[];
let store: ConsoleStore;
let commands: SceneCommands;

beforeEach(() => {
  sent = [];
  store = new ConsoleStore(
    (message) => sent.push(message),
    () => 0,
    "a",
  );
  commands = new SceneCommands(store, 2);
  store.setOnline(true);
  store.receive(stateOf("One", "Two"));
});

/** What was sent, without the ids. */
const said = () => sent.splice(0).map((message) => ({ ...message, id: undefined }));

/** The one message that was sent, which has a key. */
const keyed = () => said()[0] as unknown as { key: string };

describe("the scene", () => {
  it("gets a character that is played from then on; taken back it goes, done again it comes as it was", () => {
    commands.add();
    const add = { type: "add_character", character: "three", label: "Three", face: "old" };
    expect(said()).toMatchObject([add, { type: "enter_character", character: "three", seconds: 2 }]);
    expect(store.played.chosen).toEqual(["three"]);
    store.undo();
    const gone = keyed();
    expect(gone).toMatchObject({ type: "remove_character", character: "three" });
    store.redo();
    expect(said()).toEqual([{ type: "restore_character", key: gone.key, seconds: 2 }]);
  });

  it("gets names that are free, also while those asked for have not come yet", () => {
    for (const label of ["Three", "Four", "Five"]) {
      commands.add();
      expect(said()[0]).toMatchObject({ label, character: label.toLowerCase() });
    }
    store.receive(stateOf("One", "Two", "Three", "Four", "Five"));
    store.receive(stateOf("One", "Two", "Five"));
    commands.add();
    expect(said()[0]).toMatchObject({ character: "three" });
  });

  it("gives another name where somebody else was first, and nothing of it is to be taken back twice", () => {
    commands.add();
    const { id } = sent[0] as { id: string };
    store.receive(stateOf("One", "Two", "Three"));
    sent.length = 0;
    store.receive({ type: "refused", reason: "there is a character 'three' already", id: id, held: [] });
    expect(said()[0]).toMatchObject({ type: "add_character", character: "four", label: "Four" });
    expect(store.history.steps.undo.map(({ what }) => what)).toEqual(["add Four"]);
  });

  it("says why nobody is added where the show has another reason", () => {
    commands.add();
    store.receive({ type: "refused", reason: "there is no face 'old'", id: (sent[0] as { id: string }).id, held: [] });
    expect(store.notice).toBe("there is no face 'old'");
    expect([store.history.next("undo"), store.played.taken]).toEqual([null, ["one", "two"]]);
  });

  it("gets back who was removed by the key of the removal, each time another", () => {
    const keys = ["two", "two"].map((name) => {
      commands.remove(name);
      const { key } = keyed();
      store.undo();
      expect(said()).toEqual([{ type: "restore_character", key, seconds: 2 }]);
      return key;
    });
    expect(new Set(keys).size).toBe(2);
  });

  it("names, moves and frames", () => {
    commands.rename("two", "Kaori");
    commands.rename("two", " ");
    commands.move("two", false);
    commands.move("two", true);
    commands.frame(["one", "two"]);
    expect(said()).toMatchObject([
      { type: "rename_character", character: "two", label: "Kaori" },
      { type: "leave_character", character: "two", seconds: 2 },
      { type: "enter_character", character: "two", seconds: 2 },
      { type: "call_framing", characters: ["one", "two"], seconds: 2, easing: "smooth" },
    ]);
  });

  it("says that nothing was sent while the link is lost, and offers nothing to take back", () => {
    store.setOnline(false);
    commands.add();
    commands.remove("two");
    expect([sent, store.history.next("undo")]).toEqual([[], null]);
    expect(store.notice).toMatch(/Not sent/);
  });

  it("is full at eight", () => {
    expect(commands.whyFull).toBeNull();
    store.receive(stateOf(..."ABCDEFGH"));
    expect(commands.whyFull).toMatch(/8 characters/);
  });
});
