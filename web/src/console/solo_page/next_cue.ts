/** What comes next: the cue that stands by, GO and Back, for a thumb. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { pressed } from "../../ui/gestures";
import { base, ellipsis } from "../../ui/theme";
import { low, narrow } from "../controls/screen_sizes";
import { CueElement, warning } from "../cues/cue_element";
import type { CueTopic } from "../cues/cue_store";

const style = css`
  :host {
    display: grid;
    grid-template: auto minmax(0, 1fr) / minmax(64px, 1fr) minmax(0, 2fr);
    gap: 6px;
    padding: 6px;
    min-width: 0;
    min-height: 0;
    overflow: hidden;
  }
  .next {
    grid-column: 1 / -1;
    min-width: 0;
    line-height: 1.3;
    overflow: hidden;
  }
  .next b {
    display: block;
    ${ellipsis}
    font-size: 17px;
    color: var(--coming);
  }
  .next span {
    display: block;
    ${ellipsis}
    color: var(--dim);
  }
  .warning {
    grid-column: 1 / -1;
  }
  button {
    min-height: 48px;
    color: var(--text);
    font-weight: 600;
    touch-action: none;
  }
  .go {
    min-width: 0;
    font-size: clamp(22px, 5vmin, 44px);
    font-weight: 800;
    ${ellipsis}
    color: #03150a;
    background: var(--coming);
    border: 0;
    border-radius: 10px;
  }
  .go:hover {
    color: #03150a;
  }
  .go:active {
    background: #7df0ae;
  }
  .go:is(.end, :disabled) {
    color: var(--text);
    background: #2a2d31;
  }
  .go.paused {
    color: #1c1500;
    background: var(--attention);
  }
  @media ${narrow} or ${low} {
    :host {
      grid-template: auto / auto minmax(0, 1fr) minmax(90px, 1fr);
      gap: 4px;
      padding: 4px;
    }
    .next,
    .warning {
      grid-column: auto;
    }
    .next {
      order: 1;
      align-self: center;
    }
    .next b {
      font-size: 13px;
    }
    .go {
      order: 2;
      font-size: 20px;
    }
    button {
      min-height: 44px;
    }
  }
  @media ${low} {
    .next b ~ span {
      display: none;
    }
  }
`;

@customElement("omote-next-cue")
export class NextCue extends CueElement {
  static override styles = [base, warning, style];

  protected override readonly topics: readonly CueTopic[] = ["cues", "list", "view", "link", "manifest"];

  override render() {
    const { cues } = this;
    const { standby, paused, unheard, ignored } = cues;
    const press = pressed(() => cues.go());
    const go = paused ? "GO ON" : `GO ${standby?.number ?? ""}`;
    return html`${ignored === "" ? this.#next() : html`<div class="warning" role="alert">${ignored}</div>`}
      <button class="back" title="What stood before the last cue (Shift Space)" ?disabled=${unheard !== ""} @click=${() => cues.back()}>Back</button>
      <button class="go ${paused ? "paused" : standby === null ? "end" : ""}" title=${unheard || "GO (Space)"} ?disabled=${unheard !== ""} @pointerdown=${press.down} @click=${press.click}>${go}</button>`;
  }

  /** The cue that stands by, and the one after it. */
  #next() {
    const { standby, list } = this.cues;
    if (standby === null)
      return html`<div class="next"><span>${list.length === 0 ? html`No cues yet: <a href="/cues" target="omote-cues">record some</a>` : "The end of the list"}</span></div>`;
    const at = list.findIndex(({ identity }) => identity === standby.identity);
    const after = list[at + 1];
    return html`<div class="next"><b>${standby.number} ${this.cues.titleOf(standby)}</b>
      ${standby.note === "" ? nothing : html`<span>${standby.note}</span>`}
      <span>${after === undefined ? "then the end" : `then ${after.number} ${this.cues.titleOf(after)}`}</span></div>`;
  }
}
