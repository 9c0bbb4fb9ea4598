/** What every element of the page has: the desk it plays, the frame it paints in, the pictures it may ask for. */

import { LitElement } from "lit";
import { property } from "lit/decorators.js";
import type { Painted, Painter } from "../../ui/frame_painter";
import type { Portraits } from "../../ui/thumbnails";
import type { Desk, Topic } from "../store/console_store";

export interface Rig {
  readonly desk: Desk;
  readonly painter: Painter;
  readonly portraits: Portraits;
}

export abstract class RigElement extends LitElement {
  @property({ attribute: false }) rig!: Rig;
  #leave: (() => void)[] = [];

  get desk(): Desk {
    return this.rig.desk;
  }

  /** What it renders again for. */
  protected topics(): readonly Topic[] {
    return [];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#leave = this.topics().map((topic) => this.desk.listen(topic, () => this.requestUpdate()));
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const leave of this.#leave) leave();
  }
}

/** An element that also moves at the display's rate: `paint` writes transforms and nothing else. */
export abstract class PaintedElement extends RigElement implements Painted {
  abstract paint(now: number): void;

  override connectedCallback(): void {
    super.connectedCallback();
    void this.updateComplete.then(() => {
      if (this.isConnected) this.rig.painter.add(this);
    });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.rig.painter.delete(this);
  }
}

/** Writes a style only when it differs; reading it back would cost a layout. */
export class Written {
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
