/** Where layouts are: this browser keeps how its operator has arranged the console; the show file keeps those saved by name. */

import { FIRST, parsed, written } from "../store/console_layout";
import type { ConsoleStore } from "../store/console_store";
import type { Change, Step } from "../store/undo_history";

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

/** What has become of a choice: laid out, no such layout, or another was chosen before the show had answered. */
export type Choice = "chosen" | "missing" | "overtaken";

export class LayoutStorage {
  readonly #key: string;
  #choices = 0;

  constructor(
    private readonly store: ConsoleStore,
    name: string,
    private readonly read: ReadLayout = readLayout,
    private readonly own: () => OwnStore = () => localStorage,
  ) {
    store.chosenLayout = name;
    this.#key = `omote console ${name}`;
  }

  /** The name that was chosen or saved last. */
  get chosen(): string {
    return this.store.chosenLayout;
  }

  /** Lays the console out as this browser has it, else as the layout of the address or the default says; keeps what changes. */
  async open(): Promise<void> {
    const mine = this.#mine();
    this.#apply(mine ?? (await this.#document(this.chosen)) ?? written(FIRST));
    this.store.listen("layout", () => this.#keep());
  }

  /** Lays the console out as it was saved under a name; the newest choice wins, in whatever order the answers come. */
  async choose(name: string): Promise<Choice> {
    this.#choices += 1;
    const choice = this.#choices;
    const document = await this.#document(name);
    if (choice !== this.#choices) return "overtaken";
    if (document === null && name !== DEFAULT_LAYOUT) return "missing";
    this.store.chosenLayout = name;
    this.#apply(document ?? written(FIRST));
    return "chosen";
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
  async save(name: string): Promise<boolean> {
    const [before, document] = [await this.#document(name), written(this.store.layout)];
    const undo = before === null ? removing(name) : putting(name, before);
    const step = { what: `save the layout ${name}`, undo: [undo], redo: [putting(name, document)] };
    const sent = this.#begin(step, `Saved as ${name}: every console can choose it.`);
    if (sent) this.store.chosenLayout = name;
    return sent;
  }

  /** Gives a saved layout another name; whether it could be sent. */
  rename(name: string, to: string): boolean {
    const step = { what: `rename the layout ${name}`, undo: [renaming(to, name)], redo: [renaming(name, to)] };
    return this.#begin(step, `${name} is called ${to} now.`);
  }

  /** Takes a saved layout out of the show file; whether it could be sent. */
  async drop(name: string): Promise<boolean> {
    const document = await this.#document(name);
    if (document === null) return false;
    const step = { what: `delete the layout ${name}`, undo: [putting(name, document)], redo: [removing(name)] };
    return this.#begin(step, `Deleted the layout ${name}; consoles that it was chosen on stay as they are.`);
  }

  /** Takes a step for the first time; what the show rejects cannot be taken back. */
  #begin(step: Step, done: string): boolean {
    const refused = (reason: string): void => {
      this.store.history.skip(step);
      this.store.say(reason);
    };
    if (!this.store.takeStep(step, "redo", refused)) return false;
    this.store.offerUndo(done, step);
    return true;
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

const putting = (name: string, document: string): Change => ({ type: "set_layout", name, document });

const removing = (name: string): Change => ({ type: "drop_layout", name });

const renaming = (name: string, to: string): Change => ({ type: "rename_layout", name, to });
