/** When something small may be drawn without disturbing anybody. */

import type { DraftStore } from "./draft_store";

/** Milliseconds between two drawings, and after which one is made even where the page never rests. */
const PAUSE = 60;
const PATIENCE = 1000;

let pressed = false;
for (const kind of ["pointerdown", "pointerup", "pointercancel"] as const)
  globalThis.addEventListener?.(
    kind,
    () => {
      pressed = kind === "pointerdown";
    },
    true,
  );

/** Waits until no hand holds anything, no answer is to come, and the page has nothing else to do. */
export async function idle(store: DraftStore): Promise<void> {
  do {
    await new Promise((done) => setTimeout(done, PAUSE));
    if ("requestIdleCallback" in globalThis)
      await new Promise((done) => requestIdleCallback(done, { timeout: PATIENCE }));
  } while (pressed || store.dragging || store.waiting);
}
