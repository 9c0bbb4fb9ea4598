/** The keys of a page, over everything else but its bar. */

import { css, html, LitElement } from "lit";
import { customElement, property } from "lit/decorators.js";
import { closeOutside, curtainBelowBar, keysPage } from "./dialog_style";
import { layerWhileShown } from "./key_presses";
import { base } from "./theme";

const style = css`
  button {
    min-height: 40px;
    color: var(--text);
  }
`;

/** Tells `close`. */
@customElement("omote-keys-help")
export class KeysHelp extends LitElement {
  /** Keys, and what they do. */
  @property({ attribute: false }) keys: readonly (readonly [string, string])[] = [];

  static override styles = [base, curtainBelowBar, keysPage, style];

  constructor() {
    super();
    closeOutside(this, this.#close);
    layerWhileShown(this, "dialog", this.#close);
  }

  override firstUpdated(): void {
    this.renderRoot.querySelector("button")?.focus();
  }

  override render() {
    return html`<section class="panel" role="dialog" aria-modal="true" aria-label="Keys">
      <h2>Keys</h2>
      <dl>${this.keys.map(([keys, does]) => html`<dt>${keys}</dt><dd>${does}</dd>`)}</dl>
      <button @click=${this.#close}>Close</button>
    </section>`;
  }

  readonly #close = (): void => void this.dispatchEvent(new CustomEvent("close"));
}
