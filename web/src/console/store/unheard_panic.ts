/** A panic until the show has heard it: sent again, under its ids, by a link that comes back soon; said if it is not. */

import type { FromClient } from "../../link/messages";

/** Milliseconds in which a state shows that a panic was heard, on any link that is fit to play by. */
export const HEARD_MS = 700;
/** Milliseconds for which a panic still counts as meant when the link comes back. */
export const MEANT_MS = 5000;

export class UnheardPanic {
  #messages: readonly FromClient[] = [];
  #pressed = 0;

  /** Panic was pressed. messages: what says so, each with an id; now: the page's clock. */
  press(messages: readonly FromClient[], now: number): void {
    this.#messages = messages;
    this.#pressed = now;
  }

  /** The show has heard it, or has refused it and said so. */
  forget(): void {
    this.#messages = [];
  }

  /** What is to be sent by a link that has come back: an id that was executed changes nothing. Later it is dropped. */
  again(now: number): readonly FromClient[] {
    if (now - this.#pressed > MEANT_MS) this.forget();
    return this.#messages;
  }

  /** Whether it should have been heard by now. */
  late(now: number): boolean {
    return this.#messages.length > 0 && now - this.#pressed >= HEARD_MS;
  }
}
