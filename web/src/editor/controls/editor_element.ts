/** What every element of the editor page has: the store, and the thumbnails. */

import { LitElement } from "lit";
import { property } from "lit/decorators.js";
import type { Thumbnails } from "../../ui/thumbnails";
import type { DraftStore, Topic } from "../session/draft_store";
import type { ThumbnailRenderer } from "../session/thumbnail_renderer";

export interface EditorContext {
  readonly store: DraftStore;
  readonly thumbnails: Thumbnails;
  /** Null until the first picture can be drawn. */
  readonly thumbnailRenderer: () => ThumbnailRenderer | null;
  /** The name that other editors read. */
  readonly name: () => string;
  readonly rename: (name: string) => void;
}

export abstract class EditorElement extends LitElement {
  @property({ attribute: false }) context!: EditorContext;
  #leave: (() => void)[] = [];

  get store(): DraftStore {
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

/** The text or choice of a control that told of an event. */
export const textOf = (event: Event): string => (event.target as HTMLInputElement | HTMLSelectElement).value;
