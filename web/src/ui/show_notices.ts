/** What the crew must know of the show: it stays until this browser's operator has dismissed it. */

import type { Notice } from "../link/messages";

const KEY = "omote-dismissed-notices";
/** Dismissed notices that are remembered: more than a show has at a time. */
const MOST = 64;

/** Where a browser keeps what outlives a reload. */
export type NoticeStorage = Pick<Storage, "getItem" | "setItem">;

/** The notices that nobody has dismissed in this browser; `changed` is called when there are others. */
export class ShowNotices {
  open: readonly Notice[] = [];
  /** All of the show, read or not, oldest first. */
  all: readonly Notice[] = [];
  #dismissed: readonly string[];

  constructor(
    private readonly storage: NoticeStorage | null,
    private readonly changed: () => void,
  ) {
    this.#dismissed = readIds(storage);
  }

  /** All notices of the show, which come again and again. */
  receive(all: readonly Notice[]): void {
    this.all = all;
    this.#show();
  }

  dismiss(id: string): void {
    this.#dismiss([id]);
  }

  /** All have been read. */
  dismissAll(): void {
    if (this.open.length > 0) this.#dismiss(this.open.map(({ id }) => id));
  }

  #dismiss(ids: readonly string[]): void {
    this.#dismissed = [...this.#dismissed, ...ids].slice(-MOST);
    try {
      this.storage?.setItem(KEY, JSON.stringify(this.#dismissed));
    } catch {
      // a private window may refuse: then it is dismissed until the next reload
    }
    this.#show();
  }

  #show(): void {
    const open = this.all.filter(({ id }) => !this.#dismissed.includes(id));
    if (open.length === this.open.length && open.every(({ id }, index) => id === this.open[index]?.id)) return;
    this.open = open;
    this.changed();
  }
}

function readIds(storage: NoticeStorage | null): readonly string[] {
  try {
    const found: unknown = JSON.parse(storage?.getItem(KEY) ?? "[]");
    return Array.isArray(found) ? found.filter((id) => typeof id === "string") : [];
  } catch {
    return []; // not ours, or not allowed
  }
}
