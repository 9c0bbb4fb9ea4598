import { beforeEach, describe, expect, it } from "vitest";
import type { FromClient, State } from "../../link/messages";
import { ConsoleStore } from "../store/console_store";
import { AHEAD } from "../store/layer_state";
import { choicesFor, GazeTargetCommands, isSame, targetOf } from "./gaze_target_commands";

const character = (label: string, target = AHEAD) =>
  ({
    ...{ label, presence: 1, panics: 0, regions: {}, channels: {}, layers: {}, motion: { idle: false, target } },
    ...{ face_call: null, expression_call: null, home_face: "generic", held: null },
  }) as never;
const SEAT = targetOf({ kind: "gaze_point", name: "seat" });

let sent: FromClient[];
let store: ConsoleStore;
let commands: GazeTargetCommands;

beforeEach(() => {
  sent = [];
  store = new ConsoleStore(
    (message) => sent.push(message),
    () => 0,
    "a",
  );
  commands = new GazeTargetCommands(store);
  store.setOnline(true);
  const characters = { one: character("One", SEAT), two: character("Two") };
  store.receive({ type: "state", characters, gaze_points: { seat: [1, 0, 3] } } as unknown as State);
});

describe("what can be looked at", () => {
  it("is all but the character itself, with each camera that has a name once", () => {
    const choices = choicesFor("one", { one: { label: "One" }, two: { label: "Two" } }, ["seat"], ["", "left", "left"]);
    expect(choices.map(({ label }) => label)).toEqual(["Ahead", "Camera", "Camera left", "Two", "seat"]);
  });

  it("is the same by its name, or by its numbers where it has none", () => {
    expect(isSame(SEAT, { ...SEAT, x: 4 })).toBe(true);
    expect(isSame(targetOf({ kind: "point" }), targetOf({ kind: "point", x: 4 }))).toBe(false);
    expect(isSame(SEAT, targetOf({ kind: "character", name: "seat" }))).toBe(false);
  });
});

describe("an operator", () => {
  it("chooses whom the played character looks at", () => {
    commands.choose({ label: "Two", title: "", target: targetOf({ kind: "character", name: "two" }) });
    expect(sent).toMatchObject([{ type: "look_at", character: "one", kind: "character", name: "two" }]);
  });

  it("does not have a character look at itself", () => {
    commands.choose({ label: "One", title: "", target: targetOf({ kind: "character", name: "one" }) });
    expect(sent).toEqual([]);
  });

  it("switches the idle motion and leaves all else of it", () => {
    commands.idle(true);
    expect(sent).toMatchObject([{ type: "set_motion", character: "one", idle: true }]);
  });

  it("keeps a point and deletes one that there is", () => {
    commands.keep("box", [0, 1, 2]);
    commands.delete("seat");
    commands.delete("nobody");
    expect(sent).toMatchObject([
      { type: "set_gaze_point", name: "box", x: 0, y: 1, z: 2 },
      { type: "delete_gaze_point", name: "seat" },
    ]);
  });
});
