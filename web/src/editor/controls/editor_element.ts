/** What every element of the editor page has: the bench it works on, and the pictures it may ask for. */

import { LitElement } from "lit";
import { property } from "lit/decorators.js";
import type { Portraits } from "../../ui/thumbnails";
import type { Topic, Workbench } from "../session/draft_store";
import type { Studio } from "../session/thumbnail_renderer";

export interface EditorRig {
  readonly bench: Workbench;
  readonly portraits: Portraits;
  /** Null until the first picture can be drawn. */
  readonly studio: () => Studio | null;
  /** The name that other editors read. */
  readonly name: () => string;
  readonly rename: (name: string) => void;
}

export abstract class BenchElement extends LitElement {
  @property({ attribute: false }) rig!: EditorRig;
  #leave: (() => void)[] = [];

  get bench(): Workbench {
    return this.rig.bench;
  }

  /** What it renders again for. */
  protected topics(): readonly Topic[] {
    return [];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#leave = this.topics().map((topic) => this.bench.listen(topic, () => this.requestUpdate()));
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const leave of this.#leave) leave();
  }
}

/** The text or choice of a control that told of an event. */
export const textOf = (event: Event): string => (event.target as HTMLInputElement | HTMLSelectElement).value;
