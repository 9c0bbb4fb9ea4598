/** What every element of the page has: the store it plays, the animation frame, the thumbnails. */

import { property } from "lit/decorators.js";
import type { FramePainter, Paintable } from "../../ui/frame_painter";
import type { Thumbnails } from "../../ui/thumbnails";
import { TopicElement } from "../../ui/topic_element";
import type { ConsoleStore } from "../store/console_store";
import type { Topic } from "../store/page_store";
import type { PanicReturn } from "../store/panic_return";

/** What elements play with; each subject of the console declares its own part beside it. */
export interface ConsoleContext {
  readonly store: ConsoleStore;
  readonly painter: FramePainter;
  readonly thumbnails: Thumbnails;
  readonly panicReturn: PanicReturn;
  /** Gives this console another name, which the others read. */
  readonly rename: (name: string) => void;
}

/** An element that renders again where something changes that it shows; `context`: what its page gives it. */
export abstract class ConsoleElement<
  Context extends Pick<ConsoleContext, "store"> = ConsoleContext,
> extends TopicElement<Topic> {
  @property({ attribute: false }) context!: Context;

  get store(): ConsoleStore {
    return this.context.store;
  }
}

/** An element that also moves at the display's rate: `paint` writes transforms and nothing else. */
export abstract class AnimatedElement<Context extends Pick<ConsoleContext, "store" | "painter"> = ConsoleContext>
  extends ConsoleElement<Context>
  implements Paintable
{
  protected readonly write = new StyleWriter();

  abstract paint(now: number): void;

  override connectedCallback(): void {
    super.connectedCallback();
    void this.updateComplete.then(() => {
      if (this.isConnected) this.context.painter.add(this);
    });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.context.painter.delete(this);
  }
}

/** Writes a style only when it differs; reading it back would cost a layout. */
export class StyleWriter {
  readonly #last = new WeakMap<Element, Map<string, string>>();

  #new(element: Element, key: string, value: string): boolean {
    const values = this.#last.get(element) ?? new Map<string, string>();
    if (values.get(key) === value) return false;
    this.#last.set(element, values.set(key, value));
    return true;
  }

  style(element: HTMLElement | SVGElement, property: string, value: string): void {
    if (this.#new(element, property, value)) element.style.setProperty(property, value);
  }

  attribute(element: Element, name: string, value: string): void {
    if (this.#new(element, `@${name}`, value)) element.setAttribute(name, value);
  }

  flag(element: Element, name: string, on: boolean): void {
    if (this.#new(element, `.${name}`, String(on))) element.classList.toggle(name, on);
  }

  text(element: Element, text: string): void {
    if (this.#new(element, "text", text)) element.textContent = text;
  }
}
