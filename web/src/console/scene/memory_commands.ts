/** Memories as an operator has them: nine places on keys, and those that programs and surfaces have named. */

import { randomId } from "../../ui/browser_storage";
import type { ThumbnailSubject } from "../../ui/thumbnails";
import { lookOf } from "../cues/tracked_looks";
import type { ConsoleStore } from "../store/console_store";
import type { Step } from "../store/undo_history";

/** The names of the places that have keys. */
export const PLACES: readonly string[] = ["1", "2", "3", "4", "5", "6", "7", "8", "9"];

/** What the next press of a memory does. */
export type MemoryPress = "call" | "keep" | "delete";

/** All places: those on keys, then those that have other names. */
export const placesOf = (kept: readonly string[]): readonly string[] => [
  ...PLACES,
  ...kept.filter((name) => !PLACES.includes(name)),
];

/**
 * What the picture of a memory shows: the face and the expression that show most of it, of who is played here, else of the
 * first whom it has; null where nothing is told of it.
 */
export function pictureOf(store: ConsoleStore, name: string): ThumbnailSubject | null {
  const memory = store.newest("memory_list")?.memories.find((each) => each.name === name);
  if (memory === undefined) return null;
  const characters = Object.keys(memory.goals).map((part) => part.slice(0, part.lastIndexOf("/")));
  const who = store.played.names.find((each) => characters.includes(each)) ?? characters[0];
  if (who === undefined) return null;
  const home = store.state?.characters[who]?.home_face ?? "generic";
  const { face, expression } = lookOf(memory.goals, who, home, store.newest("pad_list")?.pads ?? []);
  const source = (axis: "face" | "expression", named: string): string =>
    (axis === "face" ? store.faces : store.expressions).find((each) => each.name === named)?.source ?? named;
  return { face: source("face", face), expression: source("expression", expression) };
}

export class MemoryCommands {
  constructor(private readonly store: ConsoleStore) {}

  get kept(): readonly string[] {
    return this.store.state?.memories ?? [];
  }

  /** Does with a memory what a press means; a call takes the time of a face's. */
  press(name: string, means: MemoryPress): void {
    const there = this.kept.includes(name);
    if (means === "keep") this.#keep(name, there);
    else if (!there) this.store.say(`Memory ${name} is empty: press Keep, then ${name}, to keep what shows.`);
    else if (means === "delete") this.#delete(name);
    else this.#call(name);
  }

  #call(name: string): void {
    const { seconds, easing } = this.store.timing.face;
    this.store.ask({ type: "call_memory", name, seconds, easing });
  }

  #keep(name: string, there: boolean): void {
    const key = randomId();
    const step: Step = {
      what: `memory ${name}`,
      undo: [{ type: "restore_memory", key }],
      redo: [{ type: "restore_memory", key }],
    };
    const refused = ({ reason }: { reason: string }): void => {
      this.store.history.skip(step);
      this.store.say(reason);
    };
    if (!this.store.ask({ type: "keep_memory", name, key }, { refused })) return;
    this.store.offerUndo(there ? `Memory ${name} is kept anew.` : `What shows is memory ${name}.`, step);
  }

  #delete(name: string): void {
    const key = randomId();
    this.store.act(`Memory ${name} is deleted.`, {
      what: `delete memory ${name}`,
      undo: [{ type: "restore_memory", key }],
      redo: [{ type: "delete_memory", name, key }],
    });
  }
}
