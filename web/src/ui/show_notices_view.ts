/** The notices of the show over a page, the newest first: each stays until it is dismissed, and takes no key. */

import { css, html, LitElement, nothing } from "lit";
import { customElement } from "lit/decorators.js";
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
  readonly notices = new ShowNotices(browserStorage(), () => this.requestUpdate());

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
      @media (min-width: 1200px) {
        :host(.in-bar) {
          top: 4px; /* where a page's bar has room in its middle, no face is covered */
        }
      }
      [role] {
        ${notice}
        ${wanted}
        align-items: center;
        padding: 4px 4px 4px 12px;
        font-size: 12.5px;
        line-height: 1.35;
        pointer-events: auto;
      }
      small {
        color: var(--dim);
        white-space: nowrap;
      }
      button {
        width: 44px;
        height: 44px;
        color: var(--attention);
        font-size: 16px;
        background: none;
        border: 0;
      }
    `,
  ];

  override render() {
    const newest = this.notices.open.at(-1);
    if (newest === undefined) return nothing;
    const more = this.notices.open.length - 1;
    return html`<div role="alert">
      <span>${newest.text} ${more > 0 ? html`<small>${more} more</small>` : nothing}</span>
      <button title="I have read it" aria-label="Dismiss" @click=${() => this.notices.dismiss(newest.id)}>✕</button>
    </div>`;
  }
}
