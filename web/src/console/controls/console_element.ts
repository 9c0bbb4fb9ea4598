/** What every element of the page has: the store it plays, the animation frame, the thumbnails. */

import { LitElement } from "lit";
import { property } from "lit/decorators.js";
import type { FramePainter, Paintable } from "../../ui/frame_painter";
import type { Thumbnails } from "../../ui/thumbnails";
import type { ConsoleDevices } from "../devices/console_devices";
import type { ConsoleLeases } from "../leases/console_leases";
import type { PanicReturn } from "../panic/panic_return";
import type { FileImports } from "../show_file/file_imports";
import type { LayoutStorage } from "../show_file/layout_storage";
import type { OwnItems } from "../show_file/own_items";
import type { ConsoleSources } from "../sources/console_sources";
import type { ConsoleStore } from "../store/console_store";
import type { Topic } from "../store/page_store";

export interface ConsoleContext {
  readonly store: ConsoleStore;
  readonly painter: FramePainter;
  readonly thumbnails: Thumbnails;
  readonly layouts: LayoutStorage;
  readonly items: OwnItems;
  readonly imports: FileImports;
  readonly devices: ConsoleDevices;
  readonly leases: ConsoleLeases;
  readonly panicReturn: PanicReturn;
  readonly sources: ConsoleSources;
  /** Gives this console another name, which the others read. */
  readonly rename: (name: string) => void;
}

export abstract class ConsoleElement extends LitElement {
  @property({ attribute: false }) context!: ConsoleContext;
  #leave: (() => void)[] = [];

  get store(): ConsoleStore {
    return this.context.store;
  }

  /** What it renders again for. */
  protected topics(): readonly Topic[] {
    return [];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#leave = this.topics().map((topic) => this.store.listen(topic, () => this.requestUpdate()));
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const leave of this.#leave) leave();
  }
}

/** An element that also moves at the display's rate: `paint` writes transforms and nothing else. */
export abstract class AnimatedElement extends ConsoleElement implements Paintable {
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

/** What was chosen in the list that an event comes from. */
export const chosenIn = (event: Event): string => (event.target as HTMLSelectElement).value;
