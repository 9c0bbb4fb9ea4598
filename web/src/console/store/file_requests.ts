/** What was asked of the show file and has no answer yet, and what to do once it has. */

import type { FromClient } from "../../link/messages";

/** What is asked of the show file, without the id that it gets. */
export type Asked = WithoutId<Extract<FromClient, { id: string }>>;
type WithoutId<Message> = Message extends unknown ? Omit<Message, "id"> : never;

/** What to do once the show has answered. */
export interface Answers {
  /** What the show works at until then, for people. */
  readonly busy?: string;
  kept?(name: string, label: string): void;
  changed?(label: string, before: string): void;
  refused?(reason: string): void;
}

/** Requests that are remembered: layouts have no answer of their own but a rejection. */
const MOST_ASKED = 64;

export class FileRequests {
  readonly #asked = new Map<string, Answers>();

  add(id: string, answers: Answers): void {
    this.#asked.set(id, answers);
    for (const [oldest] of this.#asked) if (this.#asked.size > MOST_ASKED) this.#asked.delete(oldest);
  }

  /** What to do with the answer to a request, once. */
  take(id: string): Answers | undefined {
    const answers = this.#asked.get(id);
    this.#asked.delete(id);
    return answers;
  }

  /** What the show works at; null for nothing. */
  get busy(): string | null {
    return [...this.#asked.values()].find(({ busy }) => busy !== undefined)?.busy ?? null;
  }

  /** The link was lost: no answer comes any more. */
  clear(): void {
    this.#asked.clear();
  }
}
