/** What the console tells its operator, and what of it can be taken back. */

import { CastStore } from "./cast_store";

/** Where to go on from a notice, or what to do about it. */
export type Offer =
  | { readonly label: string; readonly address: string }
  | { readonly label: string; readonly act: () => void };

export class NoticeStore extends CastStore {
  /** The last thing the operator must read, how it is meant, and what can be done about it. */
  notice: string | null = null;
  tone: "attention" | "done" = "attention";
  offers: readonly Offer[] = [];
  #undo: (() => void) | null = null;

  say(notice: string | null, tone: NoticeStore["tone"] = "attention", offers: readonly Offer[] = []): void {
    [this.notice, this.tone, this.offers] = [notice, tone, offers];
    this.tell("notice");
  }

  /** Says what was done, and takes it back on request, until something else can be taken back. */
  offerUndo(done: string, undo: () => void, others: readonly Offer[] = []): void {
    this.#undo = undo;
    this.say(done, "done", [{ label: "Undo", act: () => this.undo() }, ...others]);
  }

  /** Takes the last Keep, Clear or change of the layouts back. */
  undo(): void {
    const undo = this.#undo;
    this.#undo = null;
    if (undo === null) this.say("Nothing to undo: Keep, Clear and changes of layouts can be taken back.");
    else {
      this.say(null);
      undo();
    }
  }
}
