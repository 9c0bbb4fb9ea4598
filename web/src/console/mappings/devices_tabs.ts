/** The page of devices in two views, inputs with their bindings, and macros; over both, set-ups, which are of both. */

import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import { base, flow } from "../../ui/theme";
import { hearWhileShown } from "../../ui/topic_element";
import { MappingsElement } from "./mappings_element";
import "../devices/devices_panel";
import "./mappings_panel";
import "./setup_row";

const style = css`
  :host {
    display: grid;
    grid-template-rows: auto minmax(0, 1fr);
    gap: 8px;
    min-height: 0;
  }
  .bar {
    ${flow}
    gap: 6px 14px;
    padding: 0 2px;
  }
  [role="tablist"] {
    display: flex;
    gap: 4px;
  }
  omote-setups {
    flex: 1 1 320px;
  }
  @media (max-width: 899px) {
    :host {
      grid-template-rows: max-content max-content;
    }
  }
  @media (pointer: coarse) {
    [role="tab"] {
      min-height: 44px;
    }
  }
`;

export type DevicesView = "devices" | "mappings";

@customElement("omote-devices-tabs")
export class DevicesTabs extends MappingsElement {
  @property() view: DevicesView = location.hash === "#mappings" ? "mappings" : "devices";
  /** Its page has faders that can be touched. */
  @property({ type: Boolean }) teaches = false;

  static override styles = [base, style];

  constructor() {
    super();
    hearWhileShown(this, window, ["hashchange"], () => {
      this.view = location.hash === "#mappings" ? "mappings" : "devices";
    });
  }

  override render() {
    const { context, view } = this;
    return html`<div class="bar"><div role="tablist" aria-label="Devices">
        ${this.#tab("devices", "Inputs, bindings")}${this.#tab("mappings", "Mappings")}</div>
        <omote-setups .context=${context}></omote-setups></div>
      ${view === "devices" ? html`<omote-devices .context=${context}></omote-devices>` : html`<omote-mappings .context=${context} .teaches=${this.teaches}></omote-mappings>`}`;
  }

  #tab(view: DevicesView, label: string) {
    return html`<button role="tab" data-view=${view} aria-selected=${view === this.view} @click=${() => (this.view = view)}>${label}</button>`;
  }
}
