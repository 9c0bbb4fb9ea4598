import { describe, expect, it } from "vitest";
import type { CharacterState, ClipState, SpeechState, State } from "../link/messages";
import { comingSounds, wantedSounds } from "./stage_sound";

const speech = (fields: Partial<SpeechState>): SpeechState => ({
  number: 1,
  text: "",
  elapsed: 0,
  seconds: 1,
  sound: "",
  waiting: 0,
  next_sound: "",
  keys: [],
  ...fields,
});

const clip = (fields: Partial<ClipState>): ClipState => ({
  name: "line",
  elapsed: 0,
  seconds: 4,
  share: 1,
  loop: false,
  missing: [],
  number: 1,
  sound: "",
  heard: 0,
  turn: 0,
  silent: "",
  ...fields,
});

const state = (time: number, spoken: Record<string, SpeechState | null>, clips: ClipState[] = []): State => {
  const characters = Object.entries(spoken).map(
    ([name, speechState]) => [name, { speech: speechState, clips } as unknown as CharacterState] as const,
  );
  return { time, characters: Object.fromEntries(characters) } as unknown as State;
};

describe("the sounds of a state", () => {
  it("begin at the server's time of their first sample, before it too", () => {
    const sounds = wantedSounds(state(10, { one: speech({ sound: "a", elapsed: -0.4, number: 7 }) }), undefined);
    expect(sounds).toEqual([{ id: "one 7", key: "a", begin: 10.4 }]);
  });

  it("are none of silent lips, and none of a character that is not shown", () => {
    const shown = state(1, { one: speech({}), two: speech({ sound: "b" }), three: null });
    expect(wantedSounds(shown, "one")).toEqual([]);
    expect(wantedSounds(shown, undefined).map((sound) => sound.key)).toEqual(["b"]);
  });

  it("are one where several characters speak with the same at once, two where one is later", () => {
    const chorus = { one: speech({ sound: "a", elapsed: 0.5 }), two: speech({ sound: "a", elapsed: 0.51 }) };
    expect(wantedSounds(state(1, chorus), undefined)).toHaveLength(1);
    const canon = { ...chorus, two: speech({ sound: "a", elapsed: 0.1 }) };
    expect(wantedSounds(state(1, canon), undefined)).toHaveLength(2);
  });

  it("are those of clips too, anew with each turn, and once with the pass that is played to it", () => {
    const played = clip({ sound: "a", heard: 1.5, number: 3, turn: 2 });
    const sound = { id: "one clip 3 2", key: "a", begin: 8.5 };
    expect(wantedSounds(state(10, { one: null }, [played, clip({})]), undefined)).toEqual([sound]);
    const along = { one: speech({ sound: "a", elapsed: 1.5, number: 7 }) };
    expect(wantedSounds(state(10, along, [played]), undefined)).toEqual([{ ...sound, id: "one 7" }]);
    expect(comingSounds(state(10, { one: null }, [played]))).toEqual(["a"]);
  });

  it("are fetched before they are due, those that wait too", () => {
    expect(comingSounds(state(1, { one: speech({ sound: "a", next_sound: "b" }), two: null }))).toEqual(["a", "b"]);
  });
});
