/** Keeps the steps of the undo history with the browser's tab, so that they outlive a reload of the page. */

import { type BrowserStorage, isRecord, keep, readKept, readRecord } from "../../ui/browser_storage";
import type { ConsoleStore } from "../store/console_store";
import type { Change, Step, Steps } from "../store/undo_history";

const KEY = "omote console undo";
const VERSION = 2;

/** What takes something out of the show. */
const TAKES_AWAY = /^(delete|drop|leave|remove|unbind)/;

/** Steps, and the show that they were taken in. */
interface KeptSteps {
  readonly show: string;
  readonly steps: Steps;
}

const NONE: Steps = { undo: [], redo: [] };

/**
 * What can be taken in both ways after a reload. Nobody remembers then what was taken back last: *Redo* brings things
 * back and changes them, but takes nothing away, and nothing beyond that.
 */
function afterReload({ undo, redo }: Steps): Steps {
  const last = redo.findLastIndex((step) => step.redo.some(({ type }) => TAKES_AWAY.test(type)));
  return { undo, redo: redo.slice(last + 1) };
}

/**
 * Goes on from the steps of before a reload as soon as the show is known to be theirs, and keeps what changes; steps of
 * another show are forgotten: what they name may be something else here. `tab`: what stays with this tab alone.
 */
export function keepUndo(store: ConsoleStore, tab: BrowserStorage): void {
  const key = store.bus === "air" ? KEY : `${KEY} ${store.bus}`; // what was done on one bus is not undone on the other
  let kept = readSteps(readKept(tab, key));
  store.listen("show", () => {
    store.history.resume(kept !== null && kept.show === store.show ? afterReload(kept.steps) : NONE);
    kept = null;
  });
  store.listen("undo", () =>
    keep(tab, key, JSON.stringify({ version: VERSION, show: store.show, ...store.history.steps })),
  );
}

/** The steps in a document; null where there are none that this console can take. */
export function readSteps(document: string): KeptSteps | null {
  const { version, show, undo, redo } = readRecord(document);
  if (version !== VERSION || typeof show !== "string" || show === "") return null;
  return isListOf(undo, isStep) && isListOf(redo, isStep) ? { show, steps: { undo, redo } } : null;
}

const isListOf = <One>(value: unknown, isOne: (item: unknown) => item is One): value is One[] =>
  Array.isArray(value) && value.every(isOne);

/** What the messages hold besides is checked by the show, which rejects in a sentence what it cannot do. */
const isChange = (value: unknown): value is Change => isRecord(value) && typeof value.type === "string";

const isStep = (value: unknown): value is Step =>
  isRecord(value) &&
  typeof value.what === "string" &&
  isListOf(value.undo, isChange) &&
  isListOf(value.redo, isChange) &&
  (value.panics === undefined || typeof value.panics === "number");
