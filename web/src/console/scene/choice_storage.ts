/** Keeps which characters a console plays with the browser's tab, so that the choice outlives a reload of the page. */

import { type BrowserStorage, keep, readJson, readKept } from "../../ui/browser_storage";
import type { ConsoleStore } from "../store/console_store";

const KEY = "omote console characters";

/** Goes on with the choice of before a reload, and keeps what changes; `tab`: what stays with this tab alone. */
export function keepChoice(store: ConsoleStore, tab: BrowserStorage): void {
  const names = readChoice(readKept(tab, KEY));
  if (names !== null) store.played.choose(names);
  store.listen("characters", () => keep(tab, KEY, JSON.stringify(store.played.chosen)));
}

/** The names in a document; null where there are none. */
export function readChoice(document: string): readonly string[] | null {
  const read = readJson(document);
  const names = Array.isArray(read) && read.every((name): name is string => typeof name === "string");
  return names && read.length > 0 ? read : null;
}
