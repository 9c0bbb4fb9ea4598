/** What elements of a page do while they are on it: they hear, and render again where something changes that they show. */

import { LitElement, type ReactiveControllerHost } from "lit";

/** Begins something each time an element comes to the page; what `begin` gives is called when the element goes. */
export function whileShown(host: ReactiveControllerHost, begin: () => () => void): void {
  let end = (): void => undefined;
  host.addController({
    hostConnected: () => {
      end = begin();
    },
    hostDisconnected: () => end(),
  });
}

/** Hears events of these types on a target for as long as an element is on the page; `capture`: before others do. */
export function hearWhileShown<Heard extends Event>(
  host: ReactiveControllerHost,
  target: EventTarget,
  types: readonly string[],
  hear: (event: Heard) => void,
  capture = false,
): void {
  whileShown(host, () => {
    const ending = new AbortController();
    for (const type of types) target.addEventListener(type, hear as EventListener, { capture, signal: ending.signal });
    return () => ending.abort();
  });
}

/** Elements that render again where one of their `topics` changes. */
export abstract class TopicElement<Topic extends string> extends LitElement {
  protected readonly topics: readonly Topic[] = [];

  constructor() {
    super();
    whileShown(this, () => {
      const leave = this.topics.map((topic) => this.store.listen(topic, () => this.changed(topic)));
      return () => {
        for (const end of leave) end();
      };
    });
  }

  /** Where changes are heard of. */
  abstract get store(): { listen(topic: Topic, heard: () => void): () => void };

  /** Something changed that it shows. */
  protected changed(_: Topic): void {
    this.requestUpdate();
  }

  /** Tells whoever holds it what was pressed. */
  protected tell(what: string): void {
    this.dispatchEvent(new CustomEvent(what));
  }

  protected readonly close = (): void => this.tell("close");
}

/** The text or choice of the control that told of an event. */
export const textOf = (event: Event): string => (event.target as HTMLInputElement | HTMLSelectElement).value;
