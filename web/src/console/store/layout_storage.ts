/** Where layouts are: this browser keeps how its operator has arranged the console; the show file keeps those saved by name. */

import type { FromClient } from "../../link/messages";
import { FIRST, parsed, written } from "./console_layout";
import type { ConsoleStore } from "./console_store";

/** The layout that a console opens with where nobody has arranged it; the crew may save its own under this name. */
export const DEFAULT_LAYOUT = "Default";

/** The layout that the address chooses: `?layout=left`. */
export const layoutName = (search: string): string =>
  new URLSearchParams(search).get("layout")?.slice(0, 80) || DEFAULT_LAYOUT;

/** Reads a layout's document from the show file; null where there is none. */
export type ReadLayout = (name: string) => Promise<string | null>;

export const readLayout: ReadLayout = async (name) => {
  const response = await fetch(`/layouts/${encodeURIComponent(name)}`);
  return response.status === 200 ? response.text() : null; // 204: nothing has been saved under this name yet
};

/** What this browser keeps. */
export type OwnStore = Pick<Storage, "getItem" | "setItem">;

export class LayoutStorage {
  /** The name that was chosen or saved last. */
  chosen: string;
  readonly #key: string;

  constructor(
    private readonly store: ConsoleStore,
    name: string,
    private readonly send: (message: FromClient) => boolean,
    private readonly read: ReadLayout = readLayout,
    private readonly own: () => OwnStore = () => localStorage,
  ) {
    this.chosen = name;
    this.#key = `omote console ${name}`;
  }

  /** Lays the console out as this browser has it, else as the layout of the address or the default says; keeps what changes. */
  async open(): Promise<void> {
    const mine = this.#mine();
    this.#apply(mine ?? (await this.#document(this.chosen)) ?? written(FIRST));
    this.store.listen("layout", () => this.#keep());
  }

  /** Lays the console out as it was saved under a name; false: there is none, and the console stays as it is. */
  async choose(name: string): Promise<boolean> {
    const document = await this.#document(name);
    if (document === null && name !== DEFAULT_LAYOUT) return false;
    this.chosen = name;
    this.#apply(document ?? written(FIRST));
    return true;
  }

  /** The names to choose from, the default first. */
  get names(): readonly string[] {
    const saved = this.store.layoutNames.filter((name) => name !== DEFAULT_LAYOUT);
    return [DEFAULT_LAYOUT, ...saved.toSorted((a, b) => a.localeCompare(b))];
  }

  /** Whether the show file has a layout of this name, in this case. */
  has(name: string): boolean {
    return this.store.layoutNames.includes(name);
  }

  /** Saves the console as it is under a name, for every console of the show; whether it could be sent. */
  save(name: string): boolean {
    const sent = this.send({ type: "set_layout", name, document: written(this.store.layout) });
    if (sent) this.chosen = name;
    return sent;
  }

  /** Gives a saved layout another name; whether it could be sent. */
  rename(name: string, to: string): boolean {
    const sent = this.send({ type: "rename_layout", name, to });
    if (sent && this.chosen === name) this.chosen = to;
    return sent;
  }

  /** Takes a saved layout out of the show file; gives what puts it there again, null where nothing was sent. */
  async drop(name: string): Promise<(() => void) | null> {
    const document = await this.#document(name);
    if (document === null || !this.send({ type: "drop_layout", name })) return null;
    return () => this.send({ type: "set_layout", name, document });
  }

  #document(name: string): Promise<string | null> {
    return this.read(name).catch(() => null);
  }

  #apply(document: string): void {
    const found = parsed(document);
    if (typeof found === "string") this.store.say(found);
    else this.store.arrange(found);
  }

  /** A browser may forbid its store: then the console begins anew with each load. */
  #mine(): string | null {
    try {
      return this.own().getItem(this.#key);
    } catch {
      return null;
    }
  }

  #keep(): void {
    try {
      this.own().setItem(this.#key, written(this.store.layout));
    } catch {
      // full or forbidden: the console plays on as it is
    }
  }
}
