/** The seat of this tab: a token that a reload keeps, and that no other tab has. */

const KEY = "omote console seat";

/** The tab's token, which `make` makes the first time; `tab`: what stays with this tab alone, where that is allowed. */
export function seatToken(tab: () => Pick<Storage, "getItem" | "setItem">, make: () => string): string {
  try {
    const kept = tab().getItem(KEY);
    if (kept !== null && kept !== "") return kept.slice(0, 64);
    const token = make();
    tab().setItem(KEY, token);
    return token;
  } catch {
    return make(); // forbidden: the seat lasts as long as the page
  }
}

/** A name that nobody else has; `randomUUID` is not there on a LAN without https. */
export function randomToken(): string {
  return [...crypto.getRandomValues(new Uint32Array(2))].map((part) => part.toString(36)).join("");
}
