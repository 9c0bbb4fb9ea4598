/** What a browser keeps through a reload: of a tab, or of all of them. */

/** A store of a browser, which may forbid to ask for it. */
export type BrowserStorage = () => Pick<Storage, "getItem" | "setItem">;

/** What is kept under a key; "" where nothing is, or where the browser forbids it. */
export function readKept(storage: BrowserStorage, key: string): string {
  try {
    return storage().getItem(key) ?? "";
  } catch {
    return "";
  }
}

/** Keeps a text under a key; where the store is full or forbidden the page itself still has it. */
export function keep(storage: BrowserStorage, key: string, text: string): void {
  try {
    storage().setItem(key, text);
  } catch {
    // it lasts as long as the page
  }
}

/** What a text says as JSON; undefined where it cannot be read. */
export function readJson(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

export const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** What a text says as an object; an empty one where it says none. */
export function readRecord(text: string): Record<string, unknown> {
  const read = readJson(text);
  return isRecord(read) ? read : {};
}

/** A name that nobody else has; `randomUUID` is not there on a LAN without https. */
export const randomId = (): string =>
  [...crypto.getRandomValues(new Uint32Array(3))].map((part) => part.toString(36)).join("");
