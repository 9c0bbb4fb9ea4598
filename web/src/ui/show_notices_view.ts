/** The notices of the show over a page, the newest first: each stays until it is dismissed, and takes no key. */

import { css, html, LitElement, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import type { Notice } from "../link/messages";
import { ShowNotices } from "./show_notices";
import { base, notice, palette, wanted } from "./theme";

/** The browser's store, where it lets us have one. */
function browserStorage(): Storage | null {
  try {
    return globalThis.localStorage;
  } catch {
    return null;
  }
}

@customElement("omote-show-notices")
export class ShowNoticesView extends LitElement {
  /** All of them are seen, not the newest alone. */
  @state() private all = false;
  /** Opens what holds all of them, on a page that has it: then this shows the newest alone, in so much room as it has. */
  openLog: (() => void) | null = null;
  readonly notices = new ShowNotices(browserStorage(), () => {
    this.requestUpdate();
    this.dispatchEvent(new CustomEvent("change"));
  });

  static override styles = [
    palette,
    base,
    css`
      :host {
        position: fixed;
        z-index: 6;
        top: 58px;
        left: 50%;
        width: min(400px, 100vw - 16px);
        transform: translateX(-50%);
        pointer-events: none;
      }
      :host(.in-bar),
      :host(.in-page) {
        position: static; /* where a page's bar, or the page itself, has a place for messages */
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
      :host(.in-bar) [role] {
        padding: 0 0 0 10px;
        box-shadow: none;
      }
      :host(.in-bar) span {
        display: -webkit-box;
        overflow: hidden;
        -webkit-box-orient: vertical;
        -webkit-line-clamp: 2;
        cursor: pointer;
      }
      div div {
        display: grid;
        grid-template-columns: minmax(0, 1fr) auto auto;
        align-items: center;
        gap: 6px;
      }
      div + div {
        border-top: 1px solid #ffc53d55;
      }
      .more {
        height: 28px;
        color: var(--text);
        white-space: nowrap;
      }
      @media (pointer: coarse) {
        .more {
          height: 44px;
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
    `,
  ];

  /** Nothing to say takes no room. */
  override updated(): void {
    this.hidden = this.notices.open.length === 0;
  }

  override render() {
    const { open } = this.notices;
    if (open.length === 0) return nothing;
    const newest = open.toReversed();
    const shown = this.all ? newest : newest.slice(0, 1);
    return html`<div role="alert">${shown.map((notice, index) => this.#row(notice, index === 0 ? open.length - 1 : 0))}</div>`;
  }

  /** A notice; with the first goes what opens the others. */
  #row(notice: Notice, more: number) {
    const others = html`<button class="more" aria-expanded=${this.all} @click=${this.#toggle}>
      <small>${this.all ? "the newest" : `${more} more`}</small>
    </button>`;
    return html`<div>
      <span title=${notice.text} @click=${this.openLog}>${notice.text}</span>
      ${more > 0 ? others : html`<i></i>`}
      <button class="dismiss" title="I have read it" aria-label="Dismiss" @click=${() => this.#dismiss(notice.id)}>✕</button>
    </div>`;
  }

  readonly #toggle = (): void => {
    if (this.openLog === null) this.all = !this.all;
    else this.openLog();
  };

  #dismiss(id: string): void {
    this.notices.dismiss(id);
    if (this.notices.open.length < 2) this.all = false;
  }
}
