/** Who listens to which change of a page's state, and to which messages. */

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

/** What a union of messages has in common. */
export interface AnyMessage {
  readonly type: string;
}

/** The message of a union that has a tag. */
export type Tagged<Message extends AnyMessage, Tag extends Message["type"]> = Extract<Message, { type: Tag }>;

/** What is done with each message of a union, by its tag; one that nobody hears is left out. */
export type Hearing<Message extends AnyMessage> = {
  [Tag in Message["type"]]?: (message: Tagged<Message, Tag>) => unknown;
};

/** Calls what hears a message, if anything does. */
export const hear = <Message extends AnyMessage>(hearing: Hearing<Message>, message: Message): unknown =>
  (hearing[message.type as Message["type"]] as ((message: Message) => unknown) | undefined)?.(message);

/** The newest message of each tag, which says all of its subject; the tag is the topic of what is told. */
export class MessageStore<Message extends AnyMessage, Topic extends string = never> extends TopicStore<
  Topic | Message["type"]
> {
  readonly #newest = new Map<string, Message>();

  receive(message: Message): void {
    this.#newest.set(message.type, message);
    this.tell(message.type as Message["type"]);
  }

  newest<Tag extends Message["type"]>(tag: Tag): Tagged<Message, Tag> | null {
    return (this.#newest.get(tag) as Tagged<Message, Tag> | undefined) ?? null;
  }

  /** Calls `heard` with each message of a tag, until what it gives is called. */
  hear<Tag extends Message["type"]>(tag: Tag, heard: (message: Tagged<Message, Tag>) => void): () => void {
    return this.listen(tag, () => heard(this.newest(tag) as Tagged<Message, Tag>));
  }
}
