/** The notices of the show over a page, the newest first: each stays until it is dismissed, and takes no key. */

import { css, html, LitElement, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import type { Notice } from "../link/messages";
import { ShowNotices } from "./show_notices";
import { ageOf } from "./show_times";
import { base, notice, palette, wanted } from "./theme";

const style = css`
  :host {
    position: fixed;
    z-index: 6;
    top: 58px;
    left: 50%;
    width: min(400px, 100vw - 16px);
    transform: translateX(-50%);
    pointer-events: none;
  }
  :host(.in-place),
  :host(.in-page) {
    position: static; /* where the page has a place for messages */
    width: auto;
    transform: none;
  }
  [role] {
    ${notice}
    ${wanted}
    grid-template-columns: minmax(0, 1fr);
    max-height: 60vh;
    overflow: auto;
    padding: 4px 4px 4px 12px;
    font-size: 12.5px;
    line-height: 1.35;
    pointer-events: auto;
  }
  /* one row, for the picture gives up its height */
  :host(.in-place) [role] {
    grid-template-columns: minmax(0, 1fr) auto;
    align-items: center;
    max-height: none;
    overflow: visible;
    padding: 2px 2px 2px 10px;
  }
  :host(.in-place) span {
    max-height: 4.05em; /* three lines: what is longer scrolls, and stands in the log */
    overflow: auto;
    cursor: pointer;
  }
  :host(.in-place) div > span:only-child {
    grid-column: 1 / -1;
  }
  :host(.in-place) .all {
    grid-template-columns: auto auto;
    gap: 2px;
  }
  div div {
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    align-items: center;
    gap: 6px;
  }
  div .all {
    grid-template-columns: auto 1fr auto;
    justify-items: start;
  }
  div + div:not(.all) {
    border-top: 1px solid #ffc53d55;
  }
  .all button:not(.dismiss) {
    font-size: 11px;
    height: 28px;
    color: var(--text);
    white-space: nowrap;
  }
  @media (pointer: coarse) {
    .all button:not(.dismiss) {
      font-size: 11px;
      height: 44px;
    }
  }
  .all small {
    font-size: inherit;
  }
  @media (max-width: 599px) or (max-height: 539px) {
    :host(.in-place) span {
      max-height: 2.7em;
    }
    :host(.in-place) .all .dismiss {
      display: none; /* words keep their width; the log, which opens, has all of them read */
    }
  }
  .dismiss {
    width: 44px;
    height: 44px;
    color: var(--attention);
    font-size: 16px;
    background: none;
    border: 0;
  }
`;

@customElement("omote-show-notices")
export class ShowNoticesView extends LitElement {
  /** All of them are seen, not the newest alone. */
  @state() private all = false;
  /** Opens what holds all of them, on a page that has it: then this shows the newest alone. */
  openLog: (() => void) | null = null;
  readonly notices = new ShowNotices(
    () => localStorage,
    () => {
      this.requestUpdate();
      this.dispatchEvent(new CustomEvent("change"));
    },
  );

  static override styles = [palette, base, style];

  /** Nothing to say takes no room. */
  override updated(): void {
    this.hidden = this.notices.open.length === 0;
  }

  override render() {
    const { open } = this.notices;
    if (open.length === 0) return nothing;
    const newest = open.toReversed();
    const shown = this.all ? newest : newest.slice(0, 1);
    return html`<div role="alert">${shown.map((notice) => this.#row(notice, this.openLog === null || open.length === 1))}${open.length > 1 ? this.#others(open.length - 1, newest[0]) : nothing}</div>`;
  }

  #row(notice: Notice, alone: boolean) {
    const age = ageOf(Date.now() / 1000 - notice.time);
    return html`<div class=${notice.solved ? "solved" : ""}><span title=${notice.text} @click=${this.openLog}>${age === "" ? nothing : html`<b>${age}:</b> `}${notice.text}</span>${alone ? this.#away(notice) : nothing}</div>`;
  }

  #away({ id }: Notice) {
    return html`<button class="dismiss" title="I have read it" aria-label="Dismiss" @click=${() => this.#dismiss(id)}>✕</button>`;
  }

  /** What opens the others, and what puts all of them away, or the newest where the log has them all. */
  #others(more: number, newest: Notice | undefined) {
    return html`<div class="all">
      <button class="more" aria-expanded=${this.all} @click=${this.#toggle}><small>${this.all ? "the newest" : `${more} more`}</small></button>
      ${this.openLog === null || newest === undefined ? html`<button title="I have read all of them" @click=${this.#dismissAll}>All read</button>` : this.#away(newest)}
    </div>`;
  }

  readonly #toggle = (): void => {
    if (this.openLog === null) this.all = !this.all;
    else this.openLog();
  };

  readonly #dismissAll = (): void => {
    this.all = false;
    this.notices.dismissAll();
  };

  #dismiss(id: string): void {
    this.notices.dismiss(id);
    if (this.notices.open.length < 2) this.all = false;
  }
}
