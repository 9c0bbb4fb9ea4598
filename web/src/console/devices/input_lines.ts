/** What came in, and why something was rejected: the newest first, to be filtered and held still. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import type { InputLine } from "../../link/messages";
import { base, ellipsis, entry, selectable } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import type { Topic } from "../store/page_store";
import { DevicesElement, section } from "./devices_element";

const style = css`
  :host {
    display: grid;
    grid-template-rows: auto auto minmax(0, 1fr);
  }
  input[type="search"] {
    ${entry}
    flex: 1 1 120px;
    min-height: 26px;
  }
  label {
    display: flex;
    align-items: center;
    gap: 4px;
  }
  ol {
    min-height: 60px;
    margin: 6px 0 0;
    overflow: auto;
    font-size: 12px;
    ${selectable}
  }
  li {
    display: grid;
    grid-template-columns: 62px minmax(60px, 150px) minmax(0, 1fr);
    gap: 6px;
    padding: 3px 0;
    border-top: 1px solid var(--line);
    overflow-wrap: anywhere;
  }
  time,
  .source {
    color: var(--dim);
  }
  .moves {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(104px, 1fr));
    grid-column: 3;
    gap: 2px 4px;
  }
  @media (max-width: 899px) {
    .moves {
      grid-column: 1 / -1;
    }
  }
  .moves span {
    position: relative;
    padding: 1px 4px;
    ${ellipsis}
    border-radius: 3px;
    background: #000;
  }
  .moves i {
    position: absolute;
    inset: 0;
    transform-origin: left;
    background: #3c4656;
  }
  .moves em {
    position: relative;
    font-style: normal;
  }
`;

@customElement("omote-input-lines")
export class InputLines extends DevicesElement {
  @state() private filter = "";
  @state() private rejectedAlone = false;
  /** What is shown while it is held still; null: what comes. */
  @state() private held: readonly InputLine[] | null = null;

  static override styles = [base, section, style];

  protected override readonly topics: readonly Topic[] = ["input_log"];

  protected override changed(topic: Topic): void {
    if (this.held === null) super.changed(topic);
  }

  /** The lines that pass the filter, the newest first. */
  get shown(): readonly InputLine[] {
    const wanted = this.filter.trim().toLowerCase();
    const passes = ({ source, text, rejected }: InputLine): boolean =>
      (rejected || !this.rejectedAlone) && `${source} ${text}`.toLowerCase().includes(wanted);
    return (this.held ?? this.devices.lines).filter(passes).toReversed();
  }

  /** The channels of a face that move most, and where each stands. */
  #moves(bars: InputLine["bars"]) {
    const moving = Object.entries(bars);
    if (moving.length === 0) return nothing;
    return html`<div class="moves">${moving.map(
      ([name, value]) => html`<span title=${`${name} ${value.toFixed(2)}`}>
        <i style="transform: scaleX(${Math.min(Math.max(value, 0), 1).toFixed(3)})"></i><em>${name}</em></span>`,
    )}</div>`;
  }

  override render() {
    const { shown, held } = this;
    return html`<h2>What came in</h2>
      <div class="row">
        <input type="search" placeholder="filter" aria-label="Filter what came in" .value=${this.filter}
          @input=${(event: Event) => (this.filter = textOf(event))} />
        <label><input type="checkbox" .checked=${this.rejectedAlone} @change=${(event: Event) => (this.rejectedAlone = (event.target as HTMLInputElement).checked)} />Rejected alone</label>
        <button data-pause aria-pressed=${held !== null} @click=${() => (this.held = held === null ? this.devices.lines : null)}>${held === null ? "Pause" : "Go on"}</button>
      </div>
      <ol tabindex="0" aria-label="What came in">${shown.map(
        ({ time, source, text, rejected, count, rate, bars }) => html`<li class=${rejected ? "attention" : ""}>
          <time>${new Date(time * 1000).toLocaleTimeString([], { hour12: false })}</time><span class="source">${source}</span>
          <span>${rejected ? "rejected: " : ""}${text}${rate > 0 ? html` <b>${rate.toFixed(0)}/s</b>` : count > 1 ? html` <b>×${count}</b>` : nothing}</span>${this.#moves(bars)}</li>`,
      )}${shown.length === 0 ? html`<li><span></span><span></span><span>${this.devices.lines.length === 0 ? "Nothing came yet." : "Nothing of it passes the filter."}</span></li>` : nothing}</ol>`;
  }
}
