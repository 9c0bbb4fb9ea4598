/** What this page asks of the show that takes long (imports, exports): how far each is, and how it is ended. */

import type { Cancel, Progress } from "../link/messages";
import { randomId } from "./browser_storage";

/** A request under way; `total` 0: how much it is, is not known yet; `ending`: its end has been asked for. */
export interface LongRequest {
  readonly id: string;
  readonly title: string;
  readonly done: number;
  readonly total: number;
  readonly what: string;
  readonly ending: boolean;
}

/** The status of an answer to a request that its page ended. */
const CANCELLED = 204;

/** A request was ended by the page itself; nothing has changed. */
export class CancelledError extends Error {}

/** The long requests of a page. */
export class LongRequests {
  all: readonly LongRequest[] = [];
  /** Puts a message on the page's link; false while that is lost. */
  send: (message: Cancel) => boolean = () => false;
  readonly #listeners = new Set<() => void>();

  /** Calls `heard` whenever something changes, until what it gives is called. */
  listen(heard: () => void): () => void {
    this.#listeners.add(heard);
    return () => void this.#listeners.delete(heard);
  }

  /** Shows a request under a title until its answer has come; CancelledError where it was ended. */
  async fetch(title: string, address: string, options: RequestInit): Promise<Response | null> {
    const id = randomId();
    this.#put([...this.all, { id, title, done: 0, total: 0, what: "", ending: false }]);
    try {
      const mark = address.includes("?") ? "&" : "?";
      const answer = await fetch(`${address}${mark}request=${id}`, options).catch(() => null);
      if (answer?.status === CANCELLED) throw new CancelledError(`${title}: cancelled; nothing has changed.`);
      return answer;
    } finally {
      this.#put(this.all.filter((request) => request.id !== id));
    }
  }

  receive({ request, done, total, what }: Progress): void {
    this.#change(request, { done, total, what });
  }

  /** Asks for the end of a request; what has been done by then is answered as done. */
  cancel(id: string): void {
    if (this.send({ type: "cancel", request: id })) this.#change(id, { ending: true });
  }

  #change(id: string, change: Partial<LongRequest>): void {
    if (this.all.some((request) => request.id === id))
      this.#put(this.all.map((request) => (request.id === id ? { ...request, ...change } : request)));
  }

  #put(all: readonly LongRequest[]): void {
    this.all = all;
    for (const heard of this.#listeners) heard();
  }
}

/** How far a request is, for people. */
export function progressWords({ done, total, what, ending }: LongRequest): string {
  if (ending) return "It is being cancelled ...";
  if (total === 0) return what === "" ? "It begins ..." : `${what} ...`;
  return done < total ? `${done + 1} of ${total}: ${what}` : what;
}
