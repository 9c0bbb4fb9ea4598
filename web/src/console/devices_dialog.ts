/** The devices panel over the console. */

import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import { base } from "../ui/theme";
import { ConsoleDialog, sheet } from "./controls/console_dialog";
import type { DevicesView } from "./mappings/devices_tabs";
import "./mappings/devices_tabs";

const style = css`
  section {
    width: min(1240px, 100%);
    height: min(900px, 100%);
    padding: 10px;
    grid-template-rows: auto minmax(0, 1fr);
    gap: 8px;
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
`;

/** Over everything else but the bar. Tells `close`, and `teach` where a macro is to be learned by touch. */
@customElement("omote-devices-dialog")
export class DevicesDialog extends ConsoleDialog {
  protected override readonly takesBack = true;
  protected override readonly first = ".close";
  @property() view: DevicesView = "devices";
  static override styles = [base, sheet, style];

  override render() {
    return html`<section class="panel" role="dialog" aria-modal="true" aria-label="Devices">
      <header><h2>Devices</h2><a href="/devices${this.view === "mappings" ? "#mappings" : ""}" target="omote-devices">On a page of its own</a>
        <button class="close" @click=${this.close}>Close</button></header>
      <omote-devices-tabs .context=${this.context} .view=${this.view} teaches></omote-devices-tabs>
    </section>`;
  }
}
