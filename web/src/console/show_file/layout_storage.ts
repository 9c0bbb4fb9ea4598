/** Where layouts are: this browser keeps how its operator has arranged the console; the show file keeps those saved by name. */

import { type BrowserStorage, keep, readKept } from "../../ui/browser_storage";
import { FIRST, parsed, written } from "../store/arrangement";
import type { ConsoleStore } from "../store/console_store";
import type { Change } from "../store/undo_history";

/** The layout that a console opens with where nobody has arranged it; the crew may save its own under this name. */
export const DEFAULT_LAYOUT = "Default";

/** The layout that the address chooses: `?layout=left`; `usual`: the one without. */
export const layoutName = (search: string, usual: string = DEFAULT_LAYOUT): string =>
  new URLSearchParams(search).get("layout")?.slice(0, 80) || usual;

/** Reads a layout's document from the show file; null where there is none. */
export type ReadLayout = (name: string) => Promise<string | null>;

export const readLayout: ReadLayout = async (name) => {
  const response = await fetch(`/layouts/${encodeURIComponent(name)}`);
  return response.status === 200 ? response.text() : null; // 204: nothing has been saved under this name yet
};

/** What has become of a choice: laid out, no such layout, or another was chosen before the show had answered. */
export type Choice = "chosen" | "missing" | "overtaken";

declare module "../controls/console_element" {
  interface ConsoleContext {
    readonly layouts: LayoutStorage;
  }
}

export class LayoutStorage {
  /** The name that was chosen or saved last. */
  chosen: string;
  readonly #key: string;
  #choices = 0;

  constructor(
    private readonly store: ConsoleStore,
    name: string,
    private readonly read: ReadLayout = readLayout,
    private readonly own: BrowserStorage = () => localStorage,
  ) {
    this.chosen = name;
    store.sent.hear("rename_layout", ({ name, to }) => {
      if (name === this.chosen) this.chosen = to;
    });
    this.#key = `omote console ${name}`;
  }

  /** Lays the console out as this browser has it, else as the layout of the address or the default says; keeps what changes. */
  async open(): Promise<void> {
    const mine = readKept(this.own, this.#key);
    this.#apply(mine || (await this.#document(this.chosen)) || written(FIRST));
    this.store.listen("arrangement", () => keep(this.own, this.#key, written(this.store.arrangement)));
  }

  /** Lays the console out as it was saved under a name; the newest choice wins, in whatever order the answers come. */
  async choose(name: string): Promise<Choice> {
    this.#choices += 1;
    const choice = this.#choices;
    const document = await this.#document(name);
    if (choice !== this.#choices) return "overtaken";
    if (document === null && name !== DEFAULT_LAYOUT) return "missing";
    this.chosen = name;
    this.#apply(document ?? written(FIRST));
    return "chosen";
  }

  /** The names to choose from, the default first. */
  get names(): readonly string[] {
    const saved = this.#saved.filter((name) => name !== DEFAULT_LAYOUT);
    return [DEFAULT_LAYOUT, ...saved.toSorted((a, b) => a.localeCompare(b))];
  }

  /** Whether the show file has a layout of this name, in this case. */
  has(name: string): boolean {
    return this.#saved.includes(name);
  }

  get #saved(): readonly string[] {
    return this.store.newest("layouts")?.names ?? [];
  }

  /** Saves the console as it is under a name, for every console of the show; whether it could be sent. */
  async save(name: string): Promise<boolean> {
    const [before, document] = [await this.#document(name), written(this.store.arrangement)];
    const undo = before === null ? removing(name) : putting(name, before);
    const step = { what: `save the layout ${name}`, undo: [undo], redo: [putting(name, document)] };
    const sent = this.store.act(`Saved as ${name}: every console can choose it.`, step);
    if (sent) this.chosen = name;
    return sent;
  }

  /** Gives a saved layout another name; whether it could be sent. */
  rename(name: string, to: string): boolean {
    const step = { what: `rename the layout ${name}`, undo: [renaming(to, name)], redo: [renaming(name, to)] };
    return this.store.act(`${name} is called ${to} now.`, step);
  }

  /** Takes a saved layout out of the show file; whether it could be sent. */
  async drop(name: string): Promise<boolean> {
    const document = await this.#document(name);
    if (document === null) return false;
    const step = { what: `delete the layout ${name}`, undo: [putting(name, document)], redo: [removing(name)] };
    return this.store.act(`Deleted the layout ${name}; consoles that it was chosen on stay as they are.`, step);
  }

  #document(name: string): Promise<string | null> {
    return this.read(name).catch(() => null);
  }

  #apply(document: string): void {
    const arrangement = parsed(document);
    if (typeof arrangement === "string") this.store.say(arrangement);
    else this.store.arrange(arrangement);
  }
}

const putting = (name: string, document: string): Change => ({ type: "set_layout", name, document });

const removing = (name: string): Change => ({ type: "drop_layout", name });

const renaming = (name: string, to: string): Change => ({ type: "rename_layout", name, to });
