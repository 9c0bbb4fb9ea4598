import { beforeEach, describe, expect, it } from "vitest";
import type { FromClient, MacroMapping, State } from "../../link/messages";
import { ConsoleStore } from "../store/console_store";
import { newTarget } from "./macro_targets";
import { MappingCommands } from "./mapping_commands";
import { SetupCommands } from "./setup_commands";

const MOUTH: MacroMapping = { name: "mouth", targets: [newTarget("channel/jawOpen")], when: null };
const FURTHER: MacroMapping = { ...MOUTH, targets: [{ ...newTarget("channel/jawOpen"), high: 0.4 }] };
const AIR = { label: "One", presence: 1, macros: { mouth: { value: 0, share: 0 } } };

let now: number;
let sent: FromClient[];
let store: ConsoleStore;
let commands: MappingCommands;

const tell = (...mappings: MacroMapping[]): void =>
  store.receive({ type: "mapping_list", mappings: { one: mappings }, missing: {} });
const last = (): FromClient => sent.at(-1) as FromClient;

beforeEach(() => {
  [now, sent] = [0, []];
  store = new ConsoleStore(
    (message) => sent.push(message),
    () => now,
    "a",
  );
  commands = new MappingCommands(store, () => now);
  store.setOnline(true);
  const idle = { face_call: null, expression_call: null, panics: 0, home_face: "generic" };
  store.receive({ type: "state", characters: { one: { ...AIR, ...idle } } } as unknown as State);
  tell(MOUTH);
});

describe("an operator", () => {
  it("changes a mapping, which shows at once, and takes it back", () => {
    commands.change(FURTHER, "range");
    expect(commands.list).toEqual([FURTHER]);
    expect(last()).toMatchObject({ type: "set_mapping", character: "one", mapping: FURTHER });
    tell(FURTHER);
    store.undo();
    expect(last()).toMatchObject({ type: "set_mapping", mapping: MOUTH });
  });

  it("drags a knot: it plays now and then, and the whole drag is one step", () => {
    for (const high of [0.9, 0.8, 0.7]) {
      now += 40;
      commands.play({ ...MOUTH, targets: [{ ...newTarget("channel/jawOpen"), high }] });
    }
    expect(sent).toHaveLength(1);
    commands.change(FURTHER, "curve");
    expect(last()).toMatchObject({ mapping: FURTHER });
    expect(store.history.steps.undo).toHaveLength(1);
    store.undo();
    expect(last()).toMatchObject({ mapping: MOUTH });
  });

  it("sends what it was where a drag goes there and back, and has nothing to undo", () => {
    commands.play(FURTHER);
    commands.change(MOUTH, "curve");
    expect(last()).toMatchObject({ mapping: MOUTH });
    expect(store.history.next("undo")).toBeNull();
  });

  it("reads why a change was rejected, and what is on air shows again", () => {
    commands.change(FURTHER, "range");
    store.receive({ type: "refused", id: (last() as { id: string }).id, reason: "no." } as never);
    expect(commands.refused).toBe("no.");
    expect(commands.list).toEqual([MOUTH]);
    expect(store.history.next("undo")).toBeNull();
  });

  it("copies, renames and deletes a macro, and brings it back", () => {
    commands.copy(MOUTH);
    expect(last()).toMatchObject({ mapping: { ...MOUTH, name: "mouth-2" } });
    commands.rename("mouth", "jaw");
    expect(last()).toMatchObject({ type: "rename_mapping", name: "mouth", to: "jaw" });
    commands.drop(MOUTH);
    expect(last()).toMatchObject({ type: "drop_mapping", name: "mouth" });
    store.undo();
    expect(last()).toMatchObject({ type: "set_mapping", mapping: MOUTH });
  });

  it("sees nothing of a show of before once the link is back", () => {
    store.setOnline(false);
    expect(commands.list).toEqual([MOUTH]);
    store.setOnline(true);
    expect(commands.list).toEqual([]);
  });

  it("moves a macro of those that have one", () => {
    store.macro("mouth").nudge(0.5);
    store.macro("brows").nudge(0.5);
    store.flush();
    expect(sent).toEqual([{ type: "move_macro", character: "one", name: "mouth", value: 0.5 }]);
  });

  it("calls a set-up, and takes the call back by its id", () => {
    const setups = new SetupCommands(store);
    store.receive({ type: "setup_list", names: ["left"], called: "" });
    setups.call("left");
    const { id } = last() as { id: string };
    store.receive({ type: "setup_changed", id, name: "left", missing: ["two"] });
    expect(store.notice).toContain("two");
    store.undo();
    expect(last()).toMatchObject({ type: "restore_setup", change: id });
  });
});
