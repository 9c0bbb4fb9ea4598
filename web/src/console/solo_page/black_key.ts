/** One key that fades all stages to black, and up again. */

import { css, html } from "lit";
import { customElement, query } from "lit/decorators.js";
import { base } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";

const style = css`
  button {
    min-height: 34px;
    padding: 0 8px;
    color: var(--text);
  }
  button[aria-pressed="true"] {
    color: var(--ground);
  }
`;

@customElement("omote-black-key")
export class BlackKey extends AnimatedElement {
  @query("button") private key!: HTMLElement;

  static override styles = [base, style];

  override render() {
    return html`<button aria-pressed="false" title="Fade all stages to black; again: up (Shift B)" @click=${() => this.store.callBlack()}>Black</button>`;
  }

  paint(): void {
    this.write.attribute(this.key, "aria-pressed", String(this.store.goesBlack));
  }
}
