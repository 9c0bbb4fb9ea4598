/** The seat of this tab: a token that a reload keeps, and that no other tab has. */

import { type BrowserStorage, keep, readKept } from "../../ui/browser_storage";

const KEY = "omote console seat";

/** The tab's token, which `make` makes the first time; `tab`: what stays with this tab alone, where that is allowed. */
export function seatToken(tab: BrowserStorage, make: () => string): string {
  const token = readKept(tab, KEY).slice(0, 64) || make();
  keep(tab, KEY, token);
  return token;
}
