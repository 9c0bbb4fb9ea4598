/** Keeps the steps of the undo history with the browser's tab, so that they outlive a reload of the page. */

import type { ConsoleStore } from "../store/console_store";
import type { Change, Step, Steps } from "../store/undo_history";

const KEY = "omote console undo";
const VERSION = 1;

/** What a step may send: whatever else lies in the store was written by no console of this version. */
const TYPES: ReadonlySet<string> = new Set<Change["type"]>([
  "set_home",
  "set_channel",
  "delete_item",
  "restore_item",
  "rename_item",
  "set_layout",
  "drop_layout",
  "rename_layout",
]);

/** Goes on from the steps of before a reload, and keeps what changes; `tab`: what stays with this tab alone. */
export function keepUndo(store: ConsoleStore, tab: () => Pick<Storage, "getItem" | "setItem">): void {
  try {
    const steps = readSteps(tab().getItem(KEY) ?? "");
    if (steps !== null) store.history.resume(steps);
  } catch {
    return; // forbidden: the steps last as long as the page
  }
  store.listen("undo", () => {
    try {
      tab().setItem(KEY, JSON.stringify({ version: VERSION, ...store.history.steps }));
    } catch {
      // full: the page itself still has them
    }
  });
}

/** The steps in a document; null where there are none that this console can take. */
export function readSteps(document: string): Steps | null {
  let found: unknown;
  try {
    found = JSON.parse(document);
  } catch {
    return null;
  }
  if (!isRecord(found) || found.version !== VERSION) return null;
  const { undo, redo } = found;
  return isListOf(undo, isStep) && isListOf(redo, isStep) ? { undo, redo } : null;
}

const isRecord = (value: unknown): value is Record<string, unknown> => typeof value === "object" && value !== null;

const isListOf = <One>(value: unknown, isOne: (one: unknown) => one is One): value is One[] =>
  Array.isArray(value) && value.every(isOne);

/** What the messages hold besides is checked by the show, which rejects in a sentence what it cannot do. */
const isChange = (value: unknown): value is Change => isRecord(value) && TYPES.has(value.type as string);

const isStep = (value: unknown): value is Step =>
  isRecord(value) &&
  typeof value.what === "string" &&
  isListOf(value.undo, isChange) &&
  isListOf(value.redo, isChange) &&
  (value.panics === undefined || typeof value.panics === "number");
