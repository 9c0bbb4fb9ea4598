/** When a note was begun: that moment is meant, not the one when the sentence was ready. */

/** `now`: milliseconds of a clock that only goes on. */
export class Stamp {
  #begun: number | undefined;

  constructor(private readonly now: () => number) {}

  /** The field says this now; an empty one begins anew. */
  type(text: string): void {
    if (text.trim() === "") this.#begun = undefined;
    else this.#begun ??= this.now();
  }

  /** It was begun so many seconds ago. */
  begin(before: number): void {
    this.#begun = this.now() - before * 1000;
  }

  /** How many seconds ago it was begun; undefined where nothing is typed. An hour at most. */
  seconds(): number | undefined {
    return this.#begun === undefined ? undefined : Math.min((this.now() - this.#begun) / 1000, 3600);
  }
}
