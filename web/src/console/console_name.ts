/** What this console is called: its operator's own word, or what the show called it; both stay in this browser. */

const KEY = "omote console name";
/** Characters at most, as the wire has it (`ConsoleName`). */
export const LONGEST_CONSOLE_NAME = 24;

/** Where a browser keeps what outlives a reload; it may forbid that: then the name lasts until the next load. */
type NameStore = () => Pick<Storage, "getItem" | "setItem">;

export class ConsoleName {
  #name: string;
  /** The name is that of the browser, which another tab may have: then this tab's own is kept for this tab alone. */
  #inherited: boolean;

  /** `browser`: what all tabs of the browser share; `tab`: what stays with this one through a reload. */
  constructor(
    private readonly browser: NameStore,
    private readonly tab: NameStore,
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
    for (const store of this.#inherited ? [this.tab] : [this.tab, this.browser]) {
      try {
        store().setItem(KEY, this.#name);
      } catch {
        // full or forbidden: this page still has it
      }
    }
  }
}

function stored(store: NameStore): string {
  try {
    return (store().getItem(KEY) ?? "").slice(0, LONGEST_CONSOLE_NAME);
  } catch {
    return "";
  }
}
