/** What the crew must know of the show: it stays until this browser's operator has dismissed it. */

import type { Notice } from "../link/messages";
import { type BrowserStorage, keep, readJson, readKept } from "./browser_storage";

const KEY = "omote-dismissed-notices";
/** Dismissed notices that are remembered: more than a show has at a time. */
const MOST = 64;

/** The notices that nobody has dismissed in this browser; `changed` is called when there are others. */
export class ShowNotices {
  open: readonly Notice[] = [];
  /** All of the show, read or not, oldest first. */
  all: readonly Notice[] = [];
  #dismissed: readonly string[];

  constructor(
    private readonly storage: BrowserStorage,
    private readonly changed: () => void,
  ) {
    const ids = readJson(readKept(storage, KEY));
    this.#dismissed = Array.isArray(ids) ? ids.filter((id) => typeof id === "string") : [];
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
    keep(this.storage, KEY, JSON.stringify(this.#dismissed));
    this.#show();
  }

  #show(): void {
    const open = this.all.filter(({ id }) => !this.#dismissed.includes(id));
    if (open.length === this.open.length && open.every(({ id }, index) => id === this.open[index]?.id)) return;
    this.open = open;
    this.changed();
  }
}
