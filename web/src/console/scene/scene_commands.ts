/** What an operator does to the scene: characters come, go, are named; the picture holds some of them. */

import { MOST_CHARACTERS } from "../../link/constants";
import type { ShotSize } from "../../link/framings";
import type { CharacterState, Refused } from "../../link/messages";
import { randomId } from "../../ui/browser_storage";
import { freeLabel, nameOf } from "../store/character_names";
import type { ConsoleStore } from "../store/console_store";
import type { Change, Step } from "../store/undo_history";

/** Seconds of coming and going, and of a change of the framing, where nobody has chosen others. */
export const SECONDS = 1;

export class SceneCommands {
  /** `seconds`: of coming, going and framing. */
  constructor(
    private readonly store: ConsoleStore,
    private readonly seconds = SECONDS,
  ) {}

  get characters(): Readonly<Record<string, CharacterState>> {
    return this.store.state?.characters ?? {};
  }

  /** Why no other character can be added; null where it can. */
  get whyFull(): string | null {
    const count = this.store.played.taken.length;
    return count < MOST_CHARACTERS ? null : `a scene holds ${MOST_CHARACTERS} characters at most`;
  }

  /** Adds a character with the face of the one that is played, brings it onto the stage and plays it. */
  add(label: string = freeLabel(this.characters, this.store.played.taken)): void {
    const { played } = this.store;
    const [character, key, seconds] = [nameOf(label, played.taken), randomId(), this.seconds];
    const step: Step = {
      what: `add ${label}`,
      undo: [{ type: "remove_character", character, key }],
      redo: [{ type: "restore_character", key, seconds }],
    };
    const refused = ({ reason }: Refused): void => this.#refused(character, step, reason);
    const face = faceOf(this.store.air);
    if (!this.store.ask({ type: "add_character", character, label, face }, { refused })) return;
    this.store.ask({ type: "enter_character", character, seconds }, { refused: () => this.store.say(null) });
    played.expect(character);
    this.store.play([character]);
    this.store.offerUndo(`Added ${label}.`, step);
  }

  /** Somebody else has just added a character of the same name: this one gets another. */
  #refused(character: string, step: Step, reason: string): void {
    const { store } = this;
    store.history.skip(step);
    store.played.expect(character, false);
    if (character in this.characters && this.whyFull === null) this.add();
    else store.say(reason);
  }

  /** Takes a character out of the scene; taken back, it comes with all that it had. */
  remove(character: string): void {
    const before = this.characters[character];
    if (before === undefined) return;
    const key = randomId();
    this.store.act(`Removed ${before.label}.`, {
      what: `remove ${before.label}`,
      undo: [{ type: "restore_character", key, seconds: this.seconds }],
      redo: [{ type: "remove_character", character, key }],
    });
  }

  rename(character: string, label: string): void {
    const before = this.characters[character]?.label;
    if (before === undefined || before === label || label.trim() === "") return;
    const to = (name: string): Change => ({ type: "rename_character", character, label: name });
    const step = { what: `rename ${before}`, undo: [to(before)], redo: [to(label)] };
    this.store.act(`${before} is now called ${label}.`, step);
  }

  /** Brings a character onto the stage, or takes it off. */
  move(character: string, enters: boolean): void {
    this.store.ask({ type: enters ? "enter_character" : "leave_character", character, seconds: this.seconds });
  }

  /** A shot of these characters, of none: of all that are on the stage; as near as now. */
  frame(characters: readonly string[]): void {
    const { easing } = this.store.timing.face;
    this.store.ask({ type: "call_framing", characters: [...characters], seconds: this.seconds, easing });
  }

  /** A shot of whom the picture holds that shows so much of them. */
  size(size: ShotSize): void {
    const { easing } = this.store.timing.face;
    this.store.ask({ type: "call_framing", characters: null, seconds: this.seconds, easing, size });
  }
}

/** The face that weighs most. */
function faceOf(character: CharacterState | null): string {
  const faces = Object.entries(character?.faces ?? { generic: 1 });
  return faces.reduce((heaviest, other) => (other[1] > heaviest[1] ? other : heaviest))[0];
}
