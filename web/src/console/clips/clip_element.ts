/** What every element of clips has: the store that it shows, and what is drawn with each frame. */

import { css } from "lit";
import { property } from "lit/decorators.js";
import type { FramePainter, Paintable } from "../../ui/frame_painter";
import { entry, flow } from "../../ui/theme";
import { TopicElement } from "../../ui/topic_element";
import { StyleWriter } from "../controls/console_element";
import type { ClipStore, ClipTopic } from "./clip_store";

export abstract class ClipElement extends TopicElement<ClipTopic> {
  @property({ attribute: false }) clips!: ClipStore;

  get store(): ClipStore {
    return this.clips;
  }
}

/** One that also moves at the display's rate. */
export abstract class AnimatedClipElement extends ClipElement implements Paintable {
  @property({ attribute: false }) painter!: FramePainter;
  protected readonly write = new StyleWriter();

  abstract paint(): void;

  override connectedCallback(): void {
    super.connectedCallback();
    void this.updateComplete.then(() => {
      if (this.isConnected) this.painter.add(this);
    });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.painter.delete(this);
  }
}

/** Fields and buttons, as large as a finger where there are fingers. */
export const clipControls = css`
  button {
    min-height: var(--finger, 32px);
    color: var(--text);
  }
  button[aria-pressed="true"] {
    color: var(--ground);
  }
  label {
    ${flow}
    gap: 5px;
    color: var(--dim);
  }
  input:not([type="range"]) {
    ${entry}
    min-height: var(--finger, 30px);
    font-size: 14px;
  }
  @media (pointer: coarse) {
    :host {
      --finger: 44px;
    }
    input:not([type="range"]) {
      font-size: 16px;
    }
  }
`;

/** The number that was typed; null where it is none. */
export function numberIn(text: string): number | null {
  const number = Number(text.trim().replace(",", ".").replace("−", "-"));
  return text.trim() === "" || !Number.isFinite(number) ? null : number;
}
