/** Memories as an operator has them: nine places on keys, and those that programs and surfaces have named. */

import { randomId } from "../../ui/browser_storage";
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
