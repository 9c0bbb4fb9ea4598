/** Who listens to which change of a page's state. */

/** State whose changes are told by topic. */
export class TopicStore<Topic extends string> {
  readonly #listeners = new Map<Topic, Set<() => void>>();

  /** Calls `heard` with each change, until what it gives is called. */
  listen(topic: Topic, heard: () => void): () => void {
    const listeners = this.#listeners.get(topic) ?? new Set();
    this.#listeners.set(topic, listeners.add(heard));
    return () => listeners.delete(heard);
  }

  tell(topic: Topic): void {
    for (const heard of this.#listeners.get(topic) ?? []) heard();
  }
}
