/** A scene: what a stage draws of all characters of a state. */

import { FIRST_CHARACTER } from "../../link/constants";
import { framedAlone } from "../../link/framings";
import type { Place, State } from "../../link/messages";
import { mixPoses, mixWeights, type Pose, poseKey } from "./pose";
import type { Due } from "./timeline";

/** A character as it is drawn: its pose, where it stands, and how far it is on the stage, 0..1. */
export interface CharacterPose extends Pose {
  place: Place;
  presence: number;
}

/** What a stage draws: characters by name, the weights of framings, which sum to one, and how black the picture is, 0..1. */
export interface ScenePose {
  characters: Record<string, CharacterPose>;
  framing: Record<string, number>;
  black: number;
}

/** Where a character stands that nobody has placed. */
export const FRONT: Place = { x: 0, depth: 0, size: 1, turn: 0 };

/** One character alone in front of the camera. */
export const alone = (pose: Pose, name = FIRST_CHARACTER, presence = 1): ScenePose => ({
  characters: { [name]: { ...pose, place: FRONT, presence } },
  framing: { [name]: 1 },
  black: 0,
});

/** All characters of a state, or one of them alone; an empty scene where the state has none of that name. */
export function sceneIn(state: State, name?: string): ScenePose & Due {
  const { light, time, epoch, framing, black = 0 } = state; // an older record has none
  if (name === undefined) {
    const entries = Object.entries(state.characters).map(([key, character]) => [key, { ...character, light }] as const);
    return { characters: Object.fromEntries(entries), framing, black, time, epoch };
  }
  const character = state.characters[name];
  const own = framedAlone(framing, name);
  if (character === undefined) return { characters: {}, framing: own, black, time, epoch };
  return { ...alone({ ...character, light }, name, character.presence), framing: own, black, time, epoch };
}

/** A scene of which the picture shows one character, also one that is off the stage. */
export function closeUp(scene: ScenePose, name: string): ScenePose {
  const shown = scene.characters[name];
  if (shown === undefined) return scene;
  const characters = { ...scene.characters, [name]: { ...shown, presence: 1 } };
  return { ...scene, characters, framing: framedAlone(scene.framing, name) };
}

/** The same text for the same picture; black lies over it, and is none of it. */
export const sceneKey = ({ characters, framing }: ScenePose): string =>
  JSON.stringify([
    framing,
    Object.entries(characters).map(([name, character]) => [
      name,
      poseKey(character),
      character.place,
      character.presence,
    ]),
  ]);

/** The scene part of the way (0..1) from `from` to `to`; who is in one of them only comes, or goes. */
export function mixScenes(from: ScenePose, to: ScenePose, part: number): ScenePose {
  const characters: Record<string, CharacterPose> = {};
  for (const name of new Set([...Object.keys(to.characters), ...Object.keys(from.characters)])) {
    const [before, after] = [from.characters[name], to.characters[name]];
    if (before !== undefined && after !== undefined) characters[name] = mixCharacters(before, after, part);
    else if (after !== undefined) characters[name] = { ...after, presence: after.presence * part };
    else if (before !== undefined) characters[name] = { ...before, presence: before.presence * (1 - part) };
  }
  const black = from.black + (to.black - from.black) * part;
  return { characters, framing: mixWeights(from.framing, to.framing, part), black };
}

function mixCharacters(from: CharacterPose, to: CharacterPose, part: number): CharacterPose {
  const mixed = (name: keyof Place): number => from.place[name] + (to.place[name] - from.place[name]) * part;
  return {
    ...mixPoses(from, to, part),
    place: { x: mixed("x"), depth: mixed("depth"), size: mixed("size"), turn: mixed("turn") },
    presence: from.presence + (to.presence - from.presence) * part,
  };
}

/** The light of a scene: that of any of its characters, who all stand in the same. */
export const lightOf = ({ characters }: ScenePose): Pose["light"] | undefined => Object.values(characters)[0]?.light;
