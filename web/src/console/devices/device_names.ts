/** What the devices at this browser are called: by their name, and two of a kind by a number that stays with each. */

import { type BrowserStorage, keep, readKept, readRecord } from "../../ui/browser_storage";

const KEY = "omote device names";
/** Characters at most, as the wire has it (`DeviceName`). */
const LONGEST_DEVICE_NAME = 80;

export class DeviceNames {
  /** The name of each device that was ever here, by the browser's own id of it. */
  readonly #names: Record<string, string>;
  /** Whose names are taken now. */
  readonly #here = new Map<string, string>();

  constructor(private readonly store: BrowserStorage) {
    this.#names = readRecord(readKept(store, KEY)) as Record<string, string>;
  }

  /** The name of a device that is plugged in: the one that it had, else the first that no other here has. */
  take(id: string, called: string): string {
    const taken = new Set(this.#here.values());
    const earlierName = this.#names[id];
    const name =
      typeof earlierName === "string" && !taken.has(earlierName) ? earlierName : firstFree(readableName(called), taken);
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
    keep(this.store, KEY, JSON.stringify(this.#names));
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
    const candidate = name.slice(0, LONGEST_DEVICE_NAME - end.length) + end;
    if (!taken.has(candidate)) return candidate;
  }
}
