import { describe, expect, it } from "vitest";
import type { State } from "../../link/messages";
import { mixPoses, restPose } from "./pose";
import { alone, closeUp, FRONT, mixScenes, type ScenePose, sceneIn, sceneKey } from "./scene_pose";

const kaori = { ...restPose("kaori"), place: { x: 1, depth: 0, size: 1, turn: 0.5 }, presence: 1 };
const old = { ...restPose("old"), place: FRONT, presence: 0.8 };
const state = {
  characters: { one: kaori, two: old },
  framing: { "*": 0.25, one: 0.75 },
  light: { flat: 1 },
  time: 4,
  epoch: 2,
} as unknown as State;

describe("a scene of a state", () => {
  it("holds every character in the light of the scene, and the framing", () => {
    const scene = sceneIn(state);
    expect(Object.keys(scene.characters)).toEqual(["one", "two"]);
    expect(scene.characters.two).toMatchObject({ light: { flat: 1 }, presence: 0.8, faces: { old: 1 } });
    expect(scene).toMatchObject({ framing: state.framing, black: 0, time: 4, epoch: 2 }); // as of an older record
    for (const name of [undefined, "two", "nobody"]) expect(sceneIn({ ...state, black: 0.5 }, name).black).toBe(0.5);
  });

  it("is held by a close-up of one, also of one that is not there in full, and of nobody as it is", () => {
    const scene = sceneIn(state);
    const near = closeUp(scene, "two");
    expect(near.framing).toEqual({ two: 1 });
    expect(near.characters).toEqual({ ...scene.characters, two: { ...scene.characters.two, presence: 1 } });
    expect(closeUp(scene, "nobody")).toBe(scene);
  });

  it("of one character has it in front, wherever it stands, and as far as it is present", () => {
    const scene = sceneIn(state, "two");
    expect(scene).toMatchObject({ characters: { two: { presence: 0.8, place: FRONT } }, framing: { two: 1 }, time: 4 });
    expect(sceneIn(state, "one").characters.one?.place).toEqual(FRONT);
  });

  it("of a character that it has not is empty", () => {
    expect(sceneIn(state, "nobody").characters).toEqual({});
  });
});

describe("a mix of scenes", () => {
  const scene: ScenePose = { characters: { one: kaori, two: old }, framing: { "*": 1 }, black: 1 };

  it("mixes poses, places, presence and framings", () => {
    const other = { ...alone(restPose("dog"), "one"), framing: { one: 1 } };
    const half = mixScenes(scene, other, 0.5);
    expect(half.characters.one).toMatchObject(mixPoses(kaori, restPose("dog"), 0.5));
    expect(half.characters.one?.place).toEqual({ x: 0.5, depth: 0, size: 1, turn: 0.25 });
    expect([half.framing, half.black]).toEqual([{ "*": 0.5, one: 0.5 }, 0.5]);
    expect(mixScenes(scene, scene, 0.3)).toEqual(scene);
  });

  it("lets come and go who is in one of them only", () => {
    const without = { ...scene, characters: { one: kaori } };
    for (const part of [0, 0.25, 1]) {
      expect(mixScenes(scene, without, part).characters.two?.presence).toBeCloseTo(0.8 * (1 - part), 12);
      expect(mixScenes(without, scene, part).characters.two?.presence).toBeCloseTo(0.8 * part, 12);
    }
  });

  it("has another key wherever its picture differs", () => {
    expect(sceneKey(scene)).toBe(sceneKey(structuredClone(scene)));
    expect(sceneKey({ ...scene, black: 0.5 })).toBe(sceneKey(scene)); // a picture that fades is not drawn again
    expect(sceneKey(scene)).not.toBe(sceneKey(mixScenes(scene, alone(restPose("dog"), "one"), 0.01)));
  });
});
