import { describe, expect, it } from "vitest";
import type { CharacterState, State } from "../../link/messages";
import { charactersKey, handOn, PlayedCharacters, standing } from "./played_characters";

const character = (change: Partial<CharacterState> = {}): CharacterState =>
  ({ label: "x", presence: 1, leaves: false, panics: 0, channels: {}, ...change }) as CharacterState;
const stateOf = (characters: Record<string, CharacterState>): State => ({ characters }) as State;

describe("the characters that a console plays", () => {
  it("begin with the first of a show, before there is a state and after", () => {
    let state: State | null = null;
    const played = new PlayedCharacters(() => state);
    expect([played.names, played.lead, played.air, played.targets]).toEqual([["one"], "one", null, ["one"]]);
    state = stateOf({ one: character() });
    expect([played.names, played.targets, played.air]).toEqual([["one"], ["one"], state.characters.one]);
  });

  it("are the chosen ones that there are, else the first on the stage", () => {
    const played = new PlayedCharacters(() =>
      stateOf({ a: character({ presence: 0 }), b: character(), c: character() }),
    );
    expect(played.names).toEqual(["b"]);
    played.choose(["c", "gone", "a", "c"]);
    expect([played.names, played.lead, played.targets]).toEqual([["c", "a"], "c", ["c", "a"]]);
    played.choose(["c", "a", "b"]);
    expect(played.targets).toEqual(["*"]);
  });

  it("have weights and panics together", () => {
    const weighed = character({ panics: 2, channels: { jawOpen: 0.5 } });
    const played = new PlayedCharacters(() => stateOf({ a: character({ panics: 1 }), b: weighed }));
    played.choose(["a", "b"]);
    expect(played.weights("jawOpen", 0.75)).toEqual([
      ["a", "jawOpen", 0.75],
      ["b", "jawOpen", 0.5],
    ]);
    expect([played.panics(), played.panics(["b"]), played.panics(["gone"])]).toEqual([3, 2, 0]);
  });

  it("are listed anew when one comes, goes or is renamed, and not when it plays", () => {
    const key = (change: Partial<CharacterState>) => charactersKey(stateOf({ a: character(change) }));
    expect(key({ panics: 9, presence: 0.5 })).toBe(key({}));
    for (const change of [{ label: "y" }, { presence: 0 }, { leaves: true }]) expect(key(change)).not.toBe(key({}));
  });

  it("are named beside the tally where the picture shows one of several", () => {
    const both = stateOf({ one: character({ label: "Kaori" }), two: character({ label: "Dog", presence: 0 }) });
    let state: State | null = null;
    const played = new PlayedCharacters(() => state);
    expect(played.tally(true)).toBe("ON AIR");
    state = stateOf({ one: character() });
    expect(played.tally(true)).toBe("ON AIR");
    state = stateOf({ one: character({ presence: 0 }) });
    expect(played.tally(false)).toBe("OFF STAGE");
    state = both;
    expect(played.tally(true)).toBe("Kaori ON AIR");
    played.choose(["two"]);
    expect([played.tally(true), played.tally(false)]).toEqual(["Dog OFF STAGE", "ON AIR"]);
  });

  it("are one that is pressed, or one more or less beside the others, never none", () => {
    const played = new PlayedCharacters(() => stateOf({ one: character({}), two: character({}) }));
    expect(played.pressed("two", false)).toEqual(["two"]);
    expect(played.pressed("two", true)).toEqual(["one", "two"]);
    expect(played.pressed("one", true)).toEqual(["one"]);
    played.choose(["one", "two"]);
    expect(played.pressed("one", true)).toEqual(["two"]);
  });

  it("have hands of others on them, each named once, or none", () => {
    const hands = { "one/set_head": "Anna", "one/set_gaze": "Anna", "one/fade_face": "Ben", "two/set_head": "Cleo" };
    expect(handOn(hands, "one")).toBe("Anna, Ben");
    expect(handOn(hands, "on")).toBe("");
  });

  it("stand somewhere in words that are not on the stage", () => {
    const words = [character({}), character({ presence: 0 }), character({ leaves: true })].map(standing);
    expect(words).toEqual(["", "off stage", "going"]);
  });
});
