/** What this console is called: its operator's own word, which stays in this browser. */

const KEY = "omote console name";
/** Characters at most, as the wire has it (`ConsoleName`). */
export const LONGEST_CONSOLE_NAME = 24;

export class ConsoleName {
  #name: string;

  /** `own`: the browser's store, which it may forbid: then the name lasts until the next load. */
  constructor(private readonly own: () => Pick<Storage, "getItem" | "setItem">) {
    this.#name = this.#stored();
  }

  readonly read = (): string => this.#name;

  write(name: string): void {
    this.#name = name.trim().slice(0, LONGEST_CONSOLE_NAME);
    try {
      this.own().setItem(KEY, this.#name);
    } catch {
      // full or forbidden: this page still has it
    }
  }

  #stored(): string {
    try {
      return (this.own().getItem(KEY) ?? "").slice(0, LONGEST_CONSOLE_NAME);
    } catch {
      return "";
    }
  }
}
