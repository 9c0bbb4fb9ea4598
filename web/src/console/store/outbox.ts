/** What waits for the next animation frame: at most one message for each parameter, the newest. */

import type { FromClient } from "../../link/messages";

export class Outbox {
  readonly #waiting = new Map<string, FromClient>();

  constructor(private readonly send: (message: FromClient) => void) {}

  /** A value for a parameter: replaces the one that waits. */
  put(parameter: string, message: FromClient): void {
    this.#waiting.set(parameter, message);
  }

  /** An event (a call, a release): sent now, after all values that were set before it. */
  push(message: FromClient): void {
    this.flush();
    this.send(message);
  }

  flush(): void {
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const message of waiting) this.send(message);
  }

  /** Forgets what waits: panic, or a link that is lost. */
  clear(): void {
    this.#waiting.clear();
  }
}
