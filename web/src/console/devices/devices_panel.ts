/** The devices panel: what is at this browser, every source of the show, all bindings, and what came in. */

import { css, html } from "lit";
import { customElement, query } from "lit/decorators.js";
import { base } from "../../ui/theme";
import { whileShown } from "../../ui/topic_element";
import type { BindingTable } from "./binding_table";
import { DevicesElement } from "./devices_element";
import type { ControlPicked } from "./source_list";
import "./binding_table";
import "./browser_ports";
import "./input_lines";
import "./receiver_switches";
import "./source_list";
import "./stage_list";
import "./tracker_switches";

const style = css`
  :host {
    display: grid;
    grid-template:
      "ports bindings" auto "trackers bindings" minmax(0, 1fr) "trackers lines" minmax(0, 0.6fr)
      / minmax(300px, 0.8fr) minmax(0, 1.4fr);
    gap: 8px;
    min-height: 0;
  }
  .panel {
    padding: 10px 12px;
    min-width: 0;
    overflow: auto;
  }
  omote-browser-ports {
    grid-area: ports;
  }
  .heard {
    grid-area: trackers;
    display: grid;
    gap: 16px;
    align-content: start;
  }
  omote-bindings {
    grid-area: bindings;
  }
  omote-input-lines {
    grid-area: lines;
  }
  @media (max-width: 899px) {
    :host {
      display: block;
    }
    .panel {
      margin-bottom: 8px;
      overflow: visible;
    }
    omote-input-lines {
      height: 50vh;
    }
  }
`;

@customElement("omote-devices")
export class DevicesPanel extends DevicesElement {
  @query("omote-bindings") private table!: BindingTable;

  static override styles = [base, style];

  /** The show sends what moves only to pages that show it. */
  constructor() {
    super();
    whileShown(this, () => {
      this.devices.watch(true);
      return () => this.devices.watch(false);
    });
  }

  override render() {
    const { context } = this;
    return html`
      <omote-browser-ports class="panel" .context=${context}></omote-browser-ports>
      <div class="panel heard">
        <omote-trackers .context=${context}></omote-trackers>
        <omote-sources .context=${context} @bind=${this.#bind}></omote-sources>
        <omote-receivers .context=${context}></omote-receivers>
        <omote-stages .context=${context}></omote-stages>
      </div>
      <omote-bindings class="panel" .context=${context}></omote-bindings>
      <omote-input-lines class="panel" .context=${context}></omote-input-lines>
    `;
  }

  readonly #bind = (event: ControlPicked): void => {
    const { device, control } = event.detail;
    this.table.begin(device, control);
  };
}
