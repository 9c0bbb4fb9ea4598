/** What was asked of the show and has no answer yet, and what to do once it has. */

import type { FromClient, FromServer } from "../../link/messages";
import { type Hearing, hear } from "../../link/topics";

/** What is asked, without the id that it gets. */
export type Asked = WithoutId<Extract<FromClient, { id?: string }>>;
type WithoutId<Message> = Message extends unknown ? Omit<Message, "id"> : never;

/** What names the request that it answers. */
export type Answer = Extract<FromServer, { id: string }>;

/** What to do once the show has answered; `busy`: what it works at until then, for people. */
export type Answers = Hearing<Answer> & { readonly busy?: string };

/** Requests that are remembered: some have no answer of their own but a rejection. */
const MOST_ASKED = 64;

export class Requests {
  readonly #asked = new Map<string, Answers>();
  #count = 0;

  /** `page`: a name that no other page has. */
  constructor(private readonly page: string) {}

  /** A name for a message that is to be obeyed once. */
  nextId(): string {
    this.#count += 1;
    return `${this.page}-${this.#count}`;
  }

  add(id: string, answers: Answers): void {
    this.#asked.set(id, answers);
    for (const [oldest] of this.#asked) if (this.#asked.size > MOST_ASKED) this.#asked.delete(oldest);
  }

  /** Does what is to be done with an answer, once; what that gives. */
  receive(answer: Answer): unknown {
    const answers = this.#asked.get(answer.id) ?? {};
    this.#asked.delete(answer.id);
    return hear<Answer>(answers, answer);
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
