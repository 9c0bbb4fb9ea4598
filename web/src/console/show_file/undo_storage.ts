/** Keeps the steps of the undo history with the browser's tab, so that they outlive a reload of the page. */

import type { ConsoleStore } from "../store/console_store";
import type { Change, Step, Steps } from "../store/undo_history";

const KEY = "omote console undo";
const VERSION = 2;

/** What a step may send: whatever else lies in the store was written by no console of this version. */
const TYPES: ReadonlySet<string> = new Set<Change["type"]>([
  "set_home",
  "set_channel",
  "add_character",
  "remove_character",
  "restore_character",
  "rename_character",
  "place_character",
  "enter_character",
  "leave_character",
  "delete_item",
  "restore_item",
  "rename_item",
  "set_layout",
  "drop_layout",
  "rename_layout",
]);

/** What takes something out of the show. */
const TAKES_AWAY: ReadonlySet<string> = new Set<Change["type"]>([
  "remove_character",
  "leave_character",
  "delete_item",
  "drop_layout",
]);

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
  const last = redo.findLastIndex((step) => step.redo.some(({ type }) => TAKES_AWAY.has(type)));
  return { undo, redo: redo.slice(last + 1) };
}

/**
 * Goes on from the steps of before a reload as soon as the show is known to be theirs, and keeps what changes; steps of
 * another show are forgotten: what they name may be something else here. `tab`: what stays with this tab alone.
 */
export function keepUndo(store: ConsoleStore, tab: () => Pick<Storage, "getItem" | "setItem">): void {
  let kept: KeptSteps | null = null;
  try {
    kept = readSteps(tab().getItem(KEY) ?? "");
  } catch {
    // forbidden: the steps last as long as the page
  }
  store.listen("show", () => {
    store.history.resume(kept !== null && kept.show === store.show ? afterReload(kept.steps) : NONE);
    kept = null;
  });
  store.listen("undo", () => {
    try {
      tab().setItem(KEY, JSON.stringify({ version: VERSION, show: store.show, ...store.history.steps }));
    } catch {
      // full or forbidden: the page itself still has them
    }
  });
}

/** The steps in a document; null where there are none that this console can take. */
export function readSteps(document: string): KeptSteps | null {
  let found: unknown;
  try {
    found = JSON.parse(document);
  } catch {
    return null;
  }
  if (!isRecord(found) || found.version !== VERSION) return null;
  const { show, undo, redo } = found;
  if (typeof show !== "string" || show === "") return null;
  return isListOf(undo, isStep) && isListOf(redo, isStep) ? { show, steps: { undo, redo } } : null;
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
