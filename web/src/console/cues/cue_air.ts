/** What cues have on air: the one that was called last, each thing that still moves or waits, and what comes by itself. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { styleMap } from "lit/directives/style-map.js";
import type { CueWait } from "../../link/messages";
import { base, ellipsis } from "../../ui/theme";
import { CueElement, colourOf, warning } from "./cue_element";
import type { CueTopic } from "./cue_store";
import { agoOf, countOf, timeLeft } from "./cue_words";

const style = css`
  :host {
    overflow: auto;
    padding: 10px 12px;
  }
  .called {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr) auto;
    align-items: baseline;
    gap: 2px 10px;
    padding-left: 8px;
    border-left: 6px solid transparent;
  }
  .number {
    font-size: 30px;
    font-weight: 700;
    color: var(--air);
  }
  .label {
    font-size: 18px;
    font-weight: 600;
    overflow-wrap: anywhere;
  }
  .left {
    font-size: 26px;
    font-weight: 700;
    color: var(--air);
  }
  .since {
    grid-column: 1 / -1;
    color: var(--dim);
  }
  h2 {
    margin: 10px 0 2px;
  }
  li {
    display: grid;
    grid-template-columns: 52px minmax(0, 1fr) auto;
    gap: 8px;
    padding: 2px 0;
    font-size: 14px;
  }
  li b {
    color: var(--dim);
  }
  .what {
    ${ellipsis}
  }
  .follows {
    margin-top: 10px;
    padding: 6px 10px;
    font-size: 16px;
    font-weight: 600;
    color: var(--coming);
    border: 1px solid var(--coming);
    border-radius: 4px;
  }
  .warning {
    margin: 0 0 8px;
  }
  ul ~ .warning {
    margin: 8px 0 0;
  }
  .quiet {
    color: var(--dim);
  }
`;

@customElement("omote-cue-air")
export class CueAir extends CueElement {
  static override styles = [base, warning, style];

  protected override readonly topics: readonly CueTopic[] = ["cues", "time", "list", "characters", "view"];

  override render() {
    const { way, status, paused } = this.cues;
    const { follows, follows_in, moving, waits } = way;
    return html`${paused ? html`<div class="warning" role="status">PAUSED: cues stand still. GO goes on.</div>` : nothing}
      ${this.#called()}
      ${follows === null ? nothing : html`<div class="follows">${follows.number} ${follows.label} follows in ${countOf(follows_in)} s</div>`}
      ${
        moving.length + waits.length === 0
          ? nothing
          : html`<h2>Still moves</h2><ul class="moving">${moving.map((one) => this.#line(one, ""))}${waits.map((one) => this.#line(one, "waits "))}</ul>`
      }
      ${status.rejected.map((reason) => html`<div class="warning" role="alert">Not called: ${reason}</div>`)}`;
  }

  #called() {
    const { current, by, since, pressed } = this.cues.way;
    if (current === null) return html`<p class="quiet">No cue has been called yet.</p>`;
    const left = timeLeft(this.cues.way, this.cues.current);
    const ago = since === null ? "" : `${pressed} ${agoOf(since)} ago${by === "" ? "" : ` by ${by}`}`;
    return html`<div class="called" style=${styleMap({ borderColor: colourOf(current.colour) })}>
      <span class="number">${current.number}</span><span class="label">${this.cues.titleOf(current)}</span>
      <span class="left" title="Seconds until it has ended">${left > 0 ? countOf(left) : ""}</span>
      <span class="since">${ago}</span>
    </div>`;
  }

  #line({ number, act = "", part, seconds }: CueWait & { act?: string }, how: string) {
    return html`<li><b>${number || act}</b><span class="what">${this.cues.partOf(number, part)}</span><span>${how}${countOf(seconds)} s</span></li>`;
  }
}
