/** What the devices at this browser are called: by their name, and two of a kind by a number that stays with each. */

const KEY = "omote device names";
/** Characters at most, as the wire has it (`DeviceName`). */
const LONGEST_DEVICE_NAME = 80;

/** Where a browser keeps what outlives a reload; it may forbid that. */
export type BrowserStore = () => Pick<Storage, "getItem" | "setItem">;

export class DeviceNames {
  /** The name of each device that was ever here, by the browser's own id of it. */
  readonly #names: Record<string, string>;
  /** Whose names are taken now. */
  readonly #here = new Map<string, string>();

  constructor(private readonly store: BrowserStore) {
    this.#names = storedObject(store, KEY) as Record<string, string>;
  }

  /** The name of a device that is plugged in: the one that it had, else the first that no other here has. */
  take(id: string, called: string): string {
    const taken = new Set(this.#here.values());
    const known = this.#names[id];
    const name = typeof known === "string" && !taken.has(known) ? known : firstFree(readableName(called), taken);
    this.#here.set(id, name);
    this.#keep(id, name);
    return name;
  }

  /** The device of an id is gone; it gets its name again when it comes back. */
  leave(id: string): void {
    this.#here.delete(id);
  }

  #keep(id: string, name: string): void {
    if (this.#names[id] === name) return;
    this.#names[id] = name;
    storeObject(this.store, KEY, this.#names);
  }
}

/** What a browser has stored as an object; an empty one where there is none. */
export function storedObject(store: BrowserStore, key: string): Record<string, unknown> {
  try {
    const found: unknown = JSON.parse(store().getItem(key) ?? "{}");
    return typeof found === "object" && found !== null && !Array.isArray(found) ? { ...found } : {};
  } catch {
    return {}; // forbidden, or written by somebody else
  }
}

export function storeObject(store: BrowserStore, key: string, value: Readonly<Record<string, unknown>>): void {
  try {
    store().setItem(key, JSON.stringify(value));
  } catch {
    // full or forbidden: this page still has it
  }
}

/** A device's name as people know it: gamepads carry their numbers in it, each browser in its own way. */
export function readableName(called: string): string {
  const plain = called
    .replace(/\s*\((?=[^()]*Vendor: )(?:[^()]*?)Vendor: (\w{4}) Product: (\w{4})\)/i, " ($1:$2)")
    .replace(/^(\w{4})-(\w{4})-(.+)$/, "$3 ($1:$2)")
    .replace(/\s+/g, " ")
    .trim();
  return (plain || "device without a name").slice(0, LONGEST_DEVICE_NAME);
}

function firstFree(name: string, taken: ReadonlySet<string>): string {
  for (let number = 1; ; number += 1) {
    const end = number === 1 ? "" : ` ${number}`;
    const one = name.slice(0, LONGEST_DEVICE_NAME - end.length) + end;
    if (!taken.has(one)) return one;
  }
}
