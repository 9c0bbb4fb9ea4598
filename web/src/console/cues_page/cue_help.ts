/** The keys of the cue page, over everything else. */

import { css, html, LitElement } from "lit";
import { customElement } from "lit/decorators.js";
import { closeOutside, curtainBelowBar, keysPage } from "../../ui/dialog_style";
import { layerWhileShown } from "../../ui/key_presses";
import { base } from "../../ui/theme";
import { CUE_KEYS } from "../cues/cue_keys";

const style = css`
  button {
    min-height: 40px;
    color: var(--text);
  }
`;

/** Tells `close`. */
@customElement("omote-cue-help")
export class CueHelp extends LitElement {
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
      <dl>${CUE_KEYS.map(([keys, does]) => html`<dt>${keys}</dt><dd>${does}</dd>`)}</dl>
      <button @click=${this.#close}>Close</button>
    </section>`;
  }

  readonly #close = (): void => void this.dispatchEvent(new CustomEvent("close"));
}
