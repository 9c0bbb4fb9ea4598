/** The devices panel over the console. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { closeOutside, curtainBelowBar } from "../../ui/dialog_style";
import { layerWhileShown } from "../../ui/key_presses";
import { base } from "../../ui/theme";
import { ConsoleElement } from "../controls/console_element";
import "./devices_panel";

/** Over everything else but the bar. Tells `close`. */
@customElement("omote-devices-dialog")
export class DevicesDialog extends ConsoleElement {
  static override styles = [
    base,
    curtainBelowBar,
    css`
      section {
        width: min(1240px, 100%);
        height: min(900px, 100%);
        padding: 10px;
        display: grid;
        grid-template-rows: auto minmax(0, 1fr);
        gap: 8px;
        overflow: auto;
      }
      header {
        display: flex;
        align-items: center;
        gap: 12px;
      }
      header h2 {
        flex: 1;
      }
      a {
        color: var(--focus);
      }
    `,
  ];

  constructor() {
    super();
    closeOutside(this, this.#close);
    layerWhileShown(this, "dialog", this.#close);
  }

  override firstUpdated(): void {
    this.renderRoot.querySelector<HTMLElement>(".close")?.focus();
  }

  override render() {
    return html`<section class="panel" role="dialog" aria-modal="true" aria-label="Devices">
      <header><h2>Devices</h2><a href="/devices" target="omote-devices">On a page of its own</a>
        <button class="close" @click=${this.#close}>Close</button></header>
      <omote-devices .context=${this.context}></omote-devices>
    </section>`;
  }

  readonly #close = (): void => {
    this.dispatchEvent(new CustomEvent("close"));
  };
}
