/** What every element of the editor page has: the store, and the thumbnails. */

import { property } from "lit/decorators.js";
import type { Thumbnails } from "../../ui/thumbnails";
import { TopicElement } from "../../ui/topic_element";
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

export abstract class EditorElement extends TopicElement<Topic> {
  @property({ attribute: false }) context!: EditorContext;

  get store(): DraftStore {
    return this.context.store;
  }
}
