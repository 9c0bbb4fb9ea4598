/** The heads of the mixer's groups: a press shows a group, and each says how things stand in it. */

import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import { base, ellipsis } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";
import { narrow, tight } from "../controls/screen_sizes";
import { MIXER_GROUPS, type MixerGroup } from "../store/arrangement";
import type { LayerName } from "../store/layer_state";
import { type GroupWords, motionWords, partWords, saysWords, sourceWords, targetWords } from "./group_words";
import { layerLabel } from "./layer_commands";

/** What each group is called, and what is in it. */
const LABELS: Readonly<Record<MixerGroup, readonly [string, string]>> = {
  strips: ["Mix", "A fader for each layer"],
  sources: ["Sources", "What sends a face, whom it plays and in which parts, how it is read"],
  parts: ["By part", "How much of the chosen layer shows in each part"],
  motion: [
    "By itself, skin",
    "How much it moves by itself, also while its tracker is lost; how much of folds, blush and pallor shows",
  ],
  gaze: ["Looks at", "Whom or what the eyes look at"],
  speech: ["Says", "A line to say, and gestures"],
};

const style = css`
  :host {
    display: grid;
    grid-auto-rows: minmax(34px, 52px);
    align-content: start;
    gap: 4px;
    min-height: 0;
    overflow: auto;
    scrollbar-width: thin;
  }
  button {
    display: grid;
    align-content: center;
    padding: 0 8px;
    text-align: left;
    min-width: 0;
    line-height: 15px;
    overflow: hidden;
  }
  [data-group="strips"] {
    display: none;
  }
  b {
    font-weight: 600;
    color: var(--text);
  }
  button[aria-selected="true"] b {
    color: inherit;
  }
  b,
  span {
    ${ellipsis}
  }
  span {
    font-size: 12px;
    color: var(--dim);
  }
  button[aria-selected="true"] span {
    color: inherit;
  }
  .wanted span {
    color: var(--attention);
  }
  button[aria-selected="true"].wanted span {
    color: #7a4b00;
    font-weight: 600;
  }
  @media (pointer: coarse) {
    :host {
      grid-auto-rows: minmax(var(--finger), 52px);
      gap: 3px;
    }
  }
  @media ${tight} {
    :host {
      grid-template-columns: repeat(6, minmax(0, 1fr));
      grid-auto-rows: 44px;
      overflow: visible;
    }
    [data-group="strips"] {
      display: grid;
    }
  }
  @media ${narrow} {
    :host {
      grid-template-columns: repeat(3, minmax(0, 1fr));
    }
  }
`;

/** Tells `group` with the one that was pressed. */
@customElement("omote-group-heads")
export class GroupHeads extends AnimatedElement {
  @property() shown: MixerGroup = "sources";
  /** The layer whose parts are shown. */
  @property() layer: LayerName = "emotion";

  static override styles = [base, style];

  override render() {
    return html`<slot></slot>${MIXER_GROUPS.map((group) => {
      const [label, title] = LABELS[group];
      return html`<button role="tab" data-group=${group} aria-selected=${group === this.shown} title=${title}
        @click=${() => this.#show(group)}><b>${label}</b><span></span></button>`;
    })}`;
  }

  #show(detail: MixerGroup): void {
    this.dispatchEvent(new CustomEvent("group", { detail }));
  }

  paint(): void {
    if (this.store.air === null || this.offsetParent === null) return;
    for (const head of this.renderRoot.querySelectorAll<HTMLElement>("button")) {
      const { text, wanted } = this.#words(head.dataset.group as MixerGroup);
      this.write.text(head.lastElementChild as HTMLElement, text);
      this.write.flag(head, "wanted", wanted);
    }
  }

  #words(group: MixerGroup): GroupWords {
    const { air, sources, state } = this.store;
    if (air === null || group === "strips") return { text: "all layers", wanted: false };
    if (group === "sources") return sourceWords(sources);
    if (group === "motion") return motionWords(air);
    if (group === "gaze") return targetWords(air, state?.characters ?? {});
    if (group === "speech") return saysWords(air);
    const { text, wanted } = partWords(air, this.layer);
    return { text: `${layerLabel(this.layer)} ${text}`, wanted };
  }
}
