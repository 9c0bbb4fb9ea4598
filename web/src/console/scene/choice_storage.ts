/** Keeps which characters a console plays with the browser's tab, so that the choice outlives a reload of the page. */

import type { ConsoleStore } from "../store/console_store";

const KEY = "omote console characters";

/** Goes on with the choice of before a reload, and keeps what changes; `tab`: what stays with this tab alone. */
export function keepChoice(store: ConsoleStore, tab: () => Pick<Storage, "getItem" | "setItem">): void {
  try {
    const names = readChoice(tab().getItem(KEY) ?? "");
    if (names !== null) store.played.choose(names);
  } catch {
    return; // forbidden: the choice lasts as long as the page
  }
  store.listen("characters", () => {
    try {
      tab().setItem(KEY, JSON.stringify(store.played.chosen));
    } catch {
      // full: the page itself still has it
    }
  });
}

/** The names in a document; null where there are none. */
export function readChoice(document: string): readonly string[] | null {
  try {
    const found: unknown = JSON.parse(document);
    const names = Array.isArray(found) && found.every((one): one is string => typeof one === "string");
    return names && found.length > 0 ? found : null;
  } catch {
    return null;
  }
}
