/** The notices of the show over a page: each stays until it is dismissed, and takes no key and no focus. */

import { css, html, LitElement } from "lit";
import { customElement } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import type { Notice } from "../link/messages";
import { ShowNotices } from "./show_notices";
import { base, palette } from "./theme";

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
        width: min(440px, 100vw - 16px);
        transform: translateX(-50%);
        display: grid;
        gap: 6px;
        pointer-events: none;
      }
      [role] {
        display: grid;
        grid-template-columns: minmax(0, 1fr) auto;
        align-items: center;
        gap: 6px;
        padding: 4px 4px 4px 12px;
        border-radius: 6px;
        color: var(--text);
        font-size: 12.5px;
        line-height: 1.35;
        background: #2a2108;
        border: 1px solid var(--attention);
        box-shadow: 0 6px 24px #000a;
        overflow-wrap: anywhere;
        pointer-events: auto;
        user-select: text;
        -webkit-user-select: text;
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
    return repeat(
      this.notices.open,
      ({ id }) => id,
      (notice) => this.#notice(notice),
    );
  }

  #notice({ id, text }: Notice) {
    return html`<div role="alert" data-notice=${id}>
      <span>${text}</span>
      <button title="I have read it" aria-label="Dismiss" @click=${() => this.notices.dismiss(id)}>✕</button>
    </div>`;
  }
}
