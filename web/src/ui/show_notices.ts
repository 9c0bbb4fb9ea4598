/** What the crew must know of the show: it stays until this browser's operator has dismissed it. */

import type { Notice } from "../link/messages";
import { type BrowserStorage, keep, readJson, readKept } from "./browser_storage";
import { ageOf } from "./show_times";

const KEY = "omote-dismissed-notices";
/** Dismissed notices that are remembered: more than a show has at a time. */
const MOST = 64;
/** Seconds after which a notice is old: a page that opens then shows it once. */
const OLD = 60;
/** Seconds for which what says that something is well again stands. */
const SOLVED = 20;

/** The notices that nobody has dismissed in this browser; `changed` is called when there are others, or when
 * one reads older. */
export class ShowNotices {
  open: readonly Notice[] = [];
  /** All of the show, read or not, oldest first. */
  all: readonly Notice[] = [];
  #dismissed: readonly string[];
  /** What this page has shown, though no other will. */
  readonly #here = new Set<string>();
  /** What is open and how old it is said to be, to hear of a change of either. */
  #shown = "[]";

  /** `now`: seconds since 1970. */
  constructor(
    private readonly storage: BrowserStorage,
    private readonly changed: () => void,
    private readonly now: () => number = () => Date.now() / 1000,
  ) {
    const ids = readJson(readKept(storage, KEY));
    this.#dismissed = Array.isArray(ids) ? ids.filter((id) => typeof id === "string") : [];
  }

  /** All notices of the show, which come again and again. */
  receive(all: readonly Notice[]): void {
    this.all = all;
    const old = all.filter(({ id, time }) => !this.#dismissed.includes(id) && this.now() - time > OLD);
    if (old.length > 0) {
      for (const { id } of old) this.#here.add(id);
      this.#remember(old.map(({ id }) => id));
    }
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
    for (const id of ids) this.#here.delete(id);
    this.#remember(ids);
    this.#show();
  }

  #remember(ids: readonly string[]): void {
    this.#dismissed = [...this.#dismissed.filter((id) => !ids.includes(id)), ...ids].slice(-MOST);
    keep(this.storage, KEY, JSON.stringify(this.#dismissed));
  }

  #show(): void {
    const open = this.all.filter(
      ({ id, time, solved }) =>
        (this.#here.has(id) || !this.#dismissed.includes(id)) && !(solved && this.now() - time > SOLVED),
    );
    const shown = JSON.stringify(open.map(({ id, time }) => [id, ageOf(this.now() - time)]));
    if (shown === this.#shown) return;
    [this.open, this.#shown] = [open, shown];
    this.changed();
  }
}
