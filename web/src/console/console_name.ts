/** What this console is called: its operator's own word, or what the show called it; both stay in this browser. */

import { type BrowserStorage, keep, readKept } from "../ui/browser_storage";

const KEY = "omote console name";
/** Characters at most, as the wire has it (`ConsoleName`). */
export const LONGEST_CONSOLE_NAME = 24;

export class ConsoleName {
  #name: string;
  /** The name is that of the browser, which another tab may have: then this tab's own is kept for this tab alone. */
  #inherited: boolean;

  /** `browser`: what all tabs of the browser share; `tab`: what stays with this one through a reload. */
  constructor(
    private readonly browser: BrowserStorage,
    private readonly tab: BrowserStorage,
  ) {
    const own = stored(tab);
    this.#name = own || stored(browser);
    this.#inherited = own === "" && this.#name !== "";
  }

  readonly read = (): string => this.#name;

  /** The operator's word. */
  write(name: string): void {
    this.#inherited = false;
    this.#keep(name);
  }

  /** What the show calls this console: it asks for that the next time. */
  readonly receive = (name: string): void => this.#keep(name);

  #keep(name: string): void {
    this.#name = name.trim().slice(0, LONGEST_CONSOLE_NAME);
    for (const store of this.#inherited ? [this.tab] : [this.tab, this.browser]) keep(store, KEY, this.#name);
  }
}

const stored = (store: BrowserStorage): string => readKept(store, KEY).slice(0, LONGEST_CONSOLE_NAME);
