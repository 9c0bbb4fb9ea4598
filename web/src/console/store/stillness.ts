/** One key that lets the characters that are played hold still, or move as people do. */

import type { ConsoleStore } from "./console_store";
import type { Change } from "./undo_history";

/** As people move (`set_motion`). */
const LIVELY = 0.5;

/** Whether none of the characters that are played moves by itself. */
export function isStill({ state, played }: ConsoleStore): boolean {
  return played.names.every((name) => (state?.characters[name]?.motion?.liveliness ?? 0) === 0);
}

/** Lets all of them hold still; where they do, all move as people do. *Undo* gives each the liveliness of before. */
export function toggleStill(store: ConsoleStore): void {
  const still = !isStill(store);
  const to = (liveliness: (name: string) => number): Change[] =>
    store.played.names.map((character) => ({ type: "set_motion", character, liveliness: liveliness(character) }));
  const characters = store.state?.characters ?? {};
  store.act(still ? "Holds still." : "Moves by itself, as people do.", {
    what: still ? "hold still" : "move by itself",
    undo: to((name) => characters[name]?.motion?.liveliness ?? 0),
    redo: to(() => (still ? 0 : LIVELY)),
  });
}
