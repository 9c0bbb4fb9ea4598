import { describe, expect, test } from "vitest";
import type { CharacterState, SourceState } from "../../link/messages";
import { AHEAD } from "../store/layer_state";
import { motionWords, partWords, saysWords, sourceWords, targetWords } from "./group_words";

const source = (name: string, change: Partial<SourceState> = {}): SourceState =>
  ({ name, kind: "tracker", characters: ["one"], rate: 30, found: true, ...change }) as SourceState;
const STILL = { liveliness: 0, blinks: 1, gaze: 1, breath: 1, seed: 0, idle: false, target: AHEAD };
const air = (change: Partial<CharacterState> = {}): CharacterState =>
  ({ layers: {}, motion: STILL, speech: null, ...change }) as unknown as CharacterState;
const looking = (target: Partial<typeof AHEAD>) => air({ motion: { ...STILL, target: { ...AHEAD, ...target } } });

describe("the head of a group says", () => {
  test("who sends, and first who is lost and who plays nobody", () => {
    const phone = source("Live Link Face Mira 10.0.0.7");
    expect(sourceWords([])).toEqual({ text: "none sends", wanted: false });
    expect(sourceWords([phone])).toEqual({ text: "Live Link Face Mira", wanted: false });
    expect(sourceWords([{ ...phone, rate: 0 }])).toEqual({ text: "lost", wanted: true });
    const bot = source("bot", { kind: "program", rate: 0, characters: [] });
    expect(sourceWords([phone, bot])).toEqual({ text: "2 play", wanted: false });
    expect(sourceWords([phone, source("VMC", { characters: [] })]).text).toBe("1 plays nobody");
    expect(sourceWords([phone, source("VMC", { characters: [], found: false })]).text).toBe("1 of 2 lost");
  });

  test("how much of a layer shows", () => {
    expect(partWords(air(), "tracker").text).toBe("100");
    expect(partWords(air(), "lips").text).toBe("0 to 70");
    const layer = {
      influence: [1, 1, 1, 1, 1, 1],
      on: false,
      source: "",
      trust: 1,
      share: 0,
      strongest: {},
      sources: [],
    };
    expect(partWords(air({ layers: { tracker: layer } }), "tracker")).toEqual({ text: "off", wanted: true });
  });

  test("how it moves by itself, and that it does now in a lost tracker's place", () => {
    expect(motionWords(air()).text).toBe("holds still");
    expect(motionWords(air({ motion: { ...STILL, liveliness: 0.5, idle: true } })).text).toBe("liveliness 50");
    const idle = air({ motion: { ...STILL, idle: true } });
    expect(motionWords(idle).text).toBe("idles if lost");
    const layers = { breath: { source: "automatic" } } as unknown as CharacterState["layers"];
    expect(motionWords({ ...idle, layers })).toEqual({ text: "idles now", wanted: true });
  });

  test("at what it looks", () => {
    const cast = { two: { label: "Rex" } };
    const words = [
      { kind: "ahead" },
      { kind: "stage" },
      { kind: "stage", name: "left" },
      { kind: "character", name: "two" },
    ];
    const points = [{ kind: "gaze_point", name: "box" }, { kind: "point" }];
    const said = [...words, ...points].map(
      (target) => targetWords(looking(target as Partial<typeof AHEAD>), cast).text,
    );
    expect(said).toEqual(["ahead", "the camera", "camera left", "Rex", "box", "a point"]);
  });

  test("what is said", () => {
    const speech = {
      number: 1,
      text: "Hello",
      elapsed: 0,
      seconds: 1,
      sound: "",
      waiting: 0,
      next_sound: "",
      keys: [],
    };
    expect(
      [null, speech, { ...speech, text: "" }].map((speechState) => saysWords(air({ speech: speechState })).text),
    ).toEqual(["nothing", "Hello", "speaks"]);
  });
});
