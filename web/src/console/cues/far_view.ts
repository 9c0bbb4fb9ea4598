/** The cues for two metres: what is next in the largest type, what is on air, what comes behind it, and the time. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { clockOf } from "../../ui/show_times";
import { base, ellipsis, palette } from "../../ui/theme";
import { CueElement, warning } from "./cue_element";
import type { CueTopic } from "./cue_store";
import { agoOf, countOf, goesOnWords, timeLeft } from "./cue_words";

/** Sizes are those of a screen of 1280 by 800, whatever the screen is: 57 of its pixels are 16' of arc at two metres. */
const style = css`
  :host {
    --px: min(100vw / 1280, (100dvh - var(--bar, 0px)) / 800);
    display: flex;
    flex-direction: column;
    gap: calc(4 * var(--px));
    height: calc(100dvh - var(--bar, 0px));
    padding: calc(8 * var(--px)) calc(24 * var(--px));
    overflow: hidden;
    font-size: calc(60 * var(--px));
    line-height: 1.08;
    color: #b9bec5;
  }
  .bar {
    display: flex;
    align-items: baseline;
    justify-content: space-between;
    gap: calc(30 * var(--px));
    min-width: 0;
  }
  .bar > slot {
    flex: none;
  }
  .bar > * {
    ${ellipsis}
  }
  .clock {
    flex: none;
    font-size: calc(92 * var(--px));
    font-weight: 700;
  }
  .air {
    color: var(--air);
  }
  .air b {
    flex: none;
  }
  .air i {
    font-style: normal;
    color: var(--coming);
  }
  .moving {
    max-height: 2.16em;
    overflow: hidden;
    overflow-wrap: anywhere;
    color: #c98a80;
  }
  .moving ~ .note {
    max-height: 1.08em;
  }
  .next {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr);
    align-items: center;
    gap: calc(30 * var(--px));
    height: calc(200 * var(--px));
    color: var(--coming);
  }
  .number {
    font-size: calc(210 * var(--px));
    font-weight: 800;
    line-height: 0.94;
  }
  .number.long {
    font-size: calc(140 * var(--px));
  }
  .label {
    font-size: calc(80 * var(--px));
    font-weight: 600;
    line-height: 1.1;
    max-height: 2.2em;
    overflow: hidden;
    overflow-wrap: anywhere;
  }
  .note {
    max-height: 2.16em;
    overflow: hidden;
    overflow-wrap: anywhere;
  }
  .rest {
    display: grid;
    flex: 1;
    align-content: end;
    min-height: 0;
    overflow: hidden;
  }
  ol {
    border-top: 2px solid var(--line);
  }
  li {
    ${ellipsis}
    color: #8d949d;
  }
  .warning {
    padding: 0 calc(20 * var(--px));
  }
`;

/** Rows of what comes behind the next cue. */
const ROWS = 3;

@customElement("omote-cues-far")
export class FarView extends CueElement {
  static override styles = [palette, base, warning, style];

  protected override readonly topics: readonly CueTopic[] = ["cues", "time", "list", "view", "link", "characters"];
  #clock = 0;

  override connectedCallback(): void {
    super.connectedCallback();
    this.#clock = window.setInterval(() => this.requestUpdate(), 250);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearInterval(this.#clock);
  }

  override render() {
    const { since, by, pressed } = this.cues.way;
    return html`<div class="bar"><span class="clock" aria-label="Time of day">${clockOf(new Date())}</span><slot></slot>
        <span class="since">${since === null ? "" : `${pressed} ${agoOf(since)} ${by}`}</span></div>
      ${this.#air()}${this.#next()}
      <div class="rest">${this.#words() ?? this.#rows()}</div>`;
  }

  #air() {
    const { way } = this.cues;
    const { current, follows, follows_in } = way;
    if (current === null) return html`<div class="bar air"><span>–</span></div>`;
    const left = timeLeft(way, this.cues.current);
    return html`<div class="bar air"><span>${current.number} ${this.cues.titleOf(current)}</span>
      <b>${left > 0 ? countOf(left) : ""}${follows === null ? nothing : html`<i> ▶ ${follows.number} in ${countOf(follows_in)}</i>`}</b></div>
      ${this.#moving()}`;
  }

  /** Each thing that still moves, with whose cue. */
  #moving() {
    const { moving, waits } = this.cues.way;
    if (moving.length + waits.length === 0) return nothing;
    const words = [...moving, ...waits.map((one) => ({ ...one, act: "" }))].map(
      ({ number, act, part, seconds }) => `${number || act} ${this.cues.partOf(number, part)} ${countOf(seconds)}`,
    );
    return html`<div class="moving">${words.join(" · ")}</div>`;
  }

  #next() {
    const { standby } = this.cues;
    if (standby === null)
      return html`<div class="next"><span class="number">–</span><span class="label">no cue stands by</span></div>`;
    const after = goesOnWords(this.cues.find(standby.identity) ?? { goes_on: "", post_wait: 0 });
    const note = [after, standby.note].filter((words) => words !== "").join(" · ");
    return html`<div class="next"><span class="number ${standby.number.length > 4 ? "long" : ""}">${standby.number}</span>
        <span><div class="label">${this.cues.titleOf(standby)}</div></span></div>
      ${note === "" ? nothing : html`<div class="note">${note}</div>`}`;
  }

  /** What wants attention takes the place of what comes later. */
  #words() {
    const { unheard, ignored, paused, panicked, status } = this.cues;
    if (unheard !== "") return html`<div class="warning deaf" role="alert">${unheard}</div>`;
    if (paused) return html`<div class="warning" role="status">PAUSED</div>`;
    const said = panicked || ignored || status.rejected[0] || this.cues.show.notice;
    return said ? html`<div class="warning" role="alert">${said}</div>` : null;
  }

  #rows() {
    const { list, standby } = this.cues;
    const at = list.findIndex(({ identity }) => identity === standby?.identity);
    const rows =
      at < 0
        ? []
        : list
            .slice(at + 1)
            .filter(({ skip }) => !skip)
            .slice(0, ROWS);
    return html`<ol>${rows.map((cue) => html`<li>${cue.number} ${this.cues.titleOf(cue)}</li>`)}</ol>`;
  }
}
