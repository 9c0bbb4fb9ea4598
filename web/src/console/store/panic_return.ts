/** What a panic took off the air that can be brought back in one go: sources, liveliness, and faces for the home face. */

import type { CharacterState, GazeTargetState, State } from "../../link/messages";
import type { ConsoleStore } from "./console_store";
import { AHEAD } from "./layer_state";
import type { Offer, Question } from "./page_store";
import type { Change, Step } from "./undo_history";

type LayerKey = keyof CharacterState["layers"];
type PanickedCharacter = readonly [string, CharacterState, CharacterState];

export class PanicReturn {
  #sources: Step | null = null;
  #faces: Step | null = null;
  #text = "";

  constructor(private readonly store: ConsoleStore) {
    if (store.bus !== "air") return; // what was taken off the air is not what this page sees
    let before = store.state;
    store.hear("state", (after) => {
      this.#receive(before, after);
      before = after;
    });
  }

  /** What is offered now; null for nothing. */
  get question(): Question | null {
    const offers: Offer[] = [];
    if (this.#sources !== null) offers.push({ label: "Sources on again", act: () => this.#take("sources") });
    if (this.#faces !== null) offers.push({ label: "Faces of before", act: () => this.#take("faces") });
    return offers.length === 0 ? null : { text: this.#text, offers, dismiss: this.#dismiss };
  }

  /** Takes note of what panics ended from one state to the next: of those that this console plays, or of all at once. */
  #receive(before: State | null, after: State): void {
    const all = Object.entries(after.characters);
    const hit = all.flatMap(([name, now]): PanickedCharacter[] => {
      const was = before?.characters[name];
      return was !== undefined && was.panics < now.panics ? [[name, was, now]] : [];
    });
    const panicked = hit.length === all.length ? hit : hit.filter(([name]) => this.store.played.names.includes(name));
    const stood = this.question !== null;
    if (this.#sources?.redo.every((change) => isSo(change, after))) this.#sources = null;
    if (this.#faces?.redo.some((change) => isRecast(change, after))) this.#faces = null;
    if (panicked.length > 0) this.#note(panicked);
    else if (stood && this.question === null) this.store.tell("notice");
  }

  #note(panicked: readonly PanickedCharacter[]): void {
    const [sources, faces] = [
      panicked.filter((character) => sourcesOf(character).length > 0),
      panicked.filter(isSentHome),
    ];
    if (sources.length > 0) this.#sources = stepOf("sources on again", sources, sourcesOf);
    if (faces.length > 0) {
      const { seconds, easing } = this.store.timing.face;
      this.#faces = stepOf("faces of before", faces, (character) => faceOf(character, seconds, easing));
    } else if (sources.length > 0) this.#faces = null;
    const sentences = [
      ...(sources.length > 0 ? [`Stopped by panic: ${endedOf(sources)} of ${listed(sources)}.`] : []),
      ...(faces.length > 0 ? [`Home face: ${listed(faces)}.`] : []),
    ];
    if (sentences.length === 0) return;
    this.#text = sentences.join(" ");
    this.store.log(this.#text, "attention");
    this.store.say(null); // what was said before makes room
  }

  #take(which: "sources" | "faces"): void {
    const step = which === "sources" ? this.#sources : this.#faces;
    if (step === null || !this.store.takeStep(step, "redo", () => undefined)) return;
    if (which === "sources") this.#sources = null;
    else this.#faces = null;
    this.store.offerUndo(which === "sources" ? "Sources are on again." : "The faces of before are called.", step);
  }

  readonly #dismiss = (): void => {
    [this.#sources, this.#faces] = [null, null];
    this.store.tell("notice");
  };
}

/** Both ways of a step for some characters, each way of each made by `make`. */
function stepOf(
  what: string,
  panicked: readonly PanickedCharacter[],
  make: (character: PanickedCharacter) => readonly (readonly [Change, Change])[],
): Step {
  const changes = panicked.flatMap(make);
  return { what, undo: changes.map(([undo]) => undo), redo: changes.map(([, redo]) => redo) };
}

/** The switches and the liveliness that a panic ended: as it left them, and as they were. */
function sourcesOf([character, was, now]: PanickedCharacter): (readonly [Change, Change])[] {
  const switched = (layer: LayerKey, on: boolean): Change => ({ type: "set_layer", character, layer, on });
  const layers = Object.keys(was.layers) as LayerKey[];
  const ended = layers.filter((layer) => was.layers[layer]?.on === true && now.layers[layer]?.on === false);
  const changes = ended.map((layer) => [switched(layer, false), switched(layer, true)] as const);
  const lively = was.motion?.liveliness ?? 0;
  const target = was.motion?.target ?? AHEAD;
  const [ends, looks] = [lively > 0 && (now.motion?.liveliness ?? 0) === 0, target.kind !== "ahead"];
  const motion = ends ? [[livened(character, 0), livened(character, lively)] as const] : [];
  const aside = looks && (now.motion?.target ?? AHEAD).kind === "ahead";
  const gaze = aside ? [[looking(character, AHEAD), looking(character, target)] as const] : [];
  return [...changes, ...motion, ...gaze];
}

const ENDED: Readonly<Partial<Record<Change["type"], string>>> = {
  set_layer: "sources",
  set_motion: "liveliness",
  look_at: "what eyes follow",
};

/** What a panic ended of some characters, in words. */
function endedOf(panicked: readonly PanickedCharacter[]): string {
  const types = new Set(panicked.flatMap(sourcesOf).map(([, before]) => before.type));
  const words = Object.entries(ENDED).flatMap(([type, word]) => (types.has(type as Change["type"]) ? [word] : []));
  return words.length < 2 ? words.join() : `${words.slice(0, -1).join(", ")} and ${words.at(-1)}`;
}

const looking = (character: string, target: GazeTargetState): Change => ({ type: "look_at", character, ...target });

const livened = (character: string, liveliness: number): Change => ({ type: "set_motion", character, liveliness });

/** Whether a source or the liveliness has been brought back already; also where its character has gone. */
function isSo(change: Change, { characters }: State): boolean {
  if (change.type === "set_motion") return (characters[change.character]?.motion?.liveliness ?? 1) > 0;
  if (change.type === "look_at") return (characters[change.character]?.motion?.target.kind ?? "") !== "ahead";
  return change.type !== "set_layer" || characters[change.character]?.layers[change.layer]?.on !== false;
}

/** Whether somebody has called another face than the home face since. */
function isRecast(change: Change, { characters }: State): boolean {
  if (change.type !== "call_face") return false;
  const now = characters[change.character];
  return now === undefined || (now.face_call !== null && now.face_call.target !== now.home_face);
}

/** Whether the panic was a second one, which called the home face where another one was. */
const isSentHome = ([, was, now]: PanickedCharacter): boolean => was.home_next && mainFace(was) !== now.home_face;

function faceOf(
  [character, was, now]: PanickedCharacter,
  seconds: number,
  easing: string,
): (readonly [Change, Change])[] {
  const called = (name: string): Change => ({ type: "call_face", character, name, seconds, easing });
  return [[called(now.home_face), called(mainFace(was))]];
}

/** The face that shows most. */
const mainFace = ({ faces, home_face }: CharacterState): string =>
  Object.entries(faces).reduce((most, face) => (face[1] > most[1] ? face : most), [home_face, 0] as [
    string,
    number,
  ])[0];

const listed = (characters: readonly PanickedCharacter[]): string =>
  characters.map(([name, { label }]) => label || name).join(", ");
