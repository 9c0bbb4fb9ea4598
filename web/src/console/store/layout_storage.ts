/** Where layouts are: this browser keeps how its operator has arranged the console; the show file keeps those saved by name. */

import type { FromClient } from "../../link/messages";
import { FIRST, parsed, written } from "./console_layout";
import type { ConsoleStore } from "./console_store";

/** The layout that a console opens with where nobody has arranged it; the crew may save its own under this name. */
export const DEFAULT_LAYOUT = "Default";

/** The layout that the address chooses: `?layout=left`. */
export const layoutName = (search: string): string =>
  new URLSearchParams(search).get("layout")?.slice(0, 80) || DEFAULT_LAYOUT;

/** The show file's layouts. */
export interface SharedLayouts {
  /** A layout's document; null where there is none. */
  read(name: string): Promise<string | null>;
  names(): Promise<readonly string[]>;
}

export const sharedLayouts: SharedLayouts = {
  async read(name) {
    const response = await fetch(`/layouts/${encodeURIComponent(name)}`);
    return response.status === 200 ? response.text() : null; // 204: nothing has been saved under this name yet
  },
  async names() {
    const response = await fetch("/layouts");
    return response.status === 200 ? ((await response.json()) as string[]) : [];
  },
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
    private readonly shared: SharedLayouts = sharedLayouts,
    private readonly own: () => OwnStore = () => localStorage,
  ) {
    this.chosen = name;
    this.#key = `omote console ${name}`;
  }

  /** Lays the console out as this browser has it, else as the layout of the address or the default says; keeps what changes. */
  async open(): Promise<void> {
    const mine = this.#mine();
    if (mine === null) await this.choose(this.chosen);
    else this.#apply(mine);
    this.store.listen("layout", () => this.#keep());
  }

  /** Lays the console out as it was saved under a name. */
  async choose(name: string): Promise<void> {
    const document = await this.shared.read(name).catch(() => null);
    this.chosen = name;
    this.#apply(document ?? written(FIRST));
  }

  /** The names to choose from, the default first. */
  async names(): Promise<readonly string[]> {
    const names = await this.shared.names().catch(() => []);
    return [DEFAULT_LAYOUT, ...names.filter((name) => name !== DEFAULT_LAYOUT).sort((a, b) => a.localeCompare(b))];
  }

  /** Saves the console as it is under a name, for every console of the show; whether it could be sent. */
  save(name: string): boolean {
    const sent = this.send({ type: "set_layout", name, document: written(this.store.layout) });
    if (sent) this.chosen = name;
    return sent;
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
