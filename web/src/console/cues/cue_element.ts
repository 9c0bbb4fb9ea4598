/** What every element of cues has: the store that it shows; and the styles that they share. */

import { css } from "lit";
import { property } from "lit/decorators.js";
import { TopicElement } from "../../ui/topic_element";
import type { CueStore, CueTopic } from "./cue_store";

export abstract class CueElement extends TopicElement<CueTopic> {
  @property({ attribute: false }) cues!: CueStore;

  get store(): CueStore {
    return this.cues;
  }
}

/** The colours that cues are given, by their names. */
export const COLOURS = ["red", "orange", "yellow", "green", "cyan", "blue", "violet", "pink"] as const;

/** The colour of a cue as a browser has it; nothing where that is no colour. */
export const colourOf = (colour: string): string => (CSS.supports("color", colour) ? colour : "transparent");

/** Words that want attention. */
export const warning = css`
  .warning {
    padding: 4px 10px;
    border-radius: 4px;
    font-weight: 600;
    color: #1c1500;
    background: var(--attention);
    overflow-wrap: anywhere;
  }
  .deaf {
    color: #fff;
    background: #c3170a;
  }
`;
