/** Keeps the console's layout in the show file, so that another tablet, and this one after a reload, opens the same. */

import type { FromClient } from "../../link/messages";
import { parsed, written } from "./console_layout";
import type { ConsoleStore } from "./console_store";

/** Milliseconds that an operator's changes rest before they are kept. */
const REST = 600;

/** The name under which a page keeps its layout: `?layout=left`, for crews whose tablets differ. */
export const layoutName = (search: string): string =>
  new URLSearchParams(search).get("layout")?.slice(0, 80) || "console";

/** Reads a layout's document; null where there is none yet. */
export type Read = (name: string) => Promise<string | null>;

export async function readLayout(name: string): Promise<string | null> {
  const response = await fetch(`/layouts/${encodeURIComponent(name)}`);
  return response.status === 200 ? response.text() : null; // 204: nothing has been kept under this name yet
}

export class LayoutSync {
  #kept = "";
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly store: ConsoleStore,
    private readonly name: string,
    private readonly send: (message: FromClient) => boolean,
    private readonly rest = REST,
  ) {}

  /** Lays the console out as the show file has it, and keeps what changes from now on. */
  async open(read: Read = readLayout): Promise<void> {
    const document = await read(this.name).catch(() => null);
    const found = document === null ? null : parsed(document);
    if (typeof found === "string") this.store.say(found);
    else if (found !== null) this.store.arrange(found);
    this.#kept = written(this.store.layout);
    for (const topic of ["timing", "layout", "link"] as const) this.store.listen(topic, () => this.#later());
  }

  #later(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#keep(), this.rest);
  }

  #keep(): void {
    const document = written(this.store.layout);
    if (document === this.#kept || !this.store.online) return;
    if (this.send({ type: "set_layout", name: this.name, document })) this.#kept = document;
  }
}
