/** Channels of the source that is watched: as it sends them, and as they are read. */

import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import { base, ellipsis } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";

const style = css`
  :host {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(min(230px, 100%), 1fr));
    gap: 3px 12px;
    align-content: start;
  }
  .bar {
    display: grid;
    grid-template-columns: 118px minmax(0, 1fr) 30px;
    align-items: center;
    gap: 6px;
    font-size: 12px;
    color: var(--dim);
  }
  .bar.wanted {
    color: var(--text);
    font-weight: 600;
  }
  .bar span {
    ${ellipsis}
  }
  .ways {
    display: grid;
    gap: 1px;
  }
  i {
    height: 6px;
    overflow: hidden;
    background: #000;
    border-radius: 2px;
  }
  b {
    display: block;
    height: 100%;
    transform-origin: left;
    transform: scaleX(0);
    background: var(--edge);
  }
  i + i b {
    background: var(--air);
  }
  output {
    text-align: right;
  }
`;

@customElement("omote-value-bars")
export class ValueBars extends AnimatedElement {
  /** The channels that are shown, in their order. */
  @property({ attribute: false }) names: readonly string[] = [];
  /** Those that are measured now. */
  @property({ attribute: false }) wanted: readonly string[] = [];

  static override styles = [base, style];

  override render() {
    return this.names.map(
      (name) => html`<div class="bar ${this.wanted.includes(name) ? "wanted" : ""}" data-name=${name} title=${name}>
        <span>${this.store.label("expression", name)}</span><div class="ways"><i><b></b></i><i><b></b></i></div><output></output></div>`,
    );
  }

  paint(): void {
    const { watched } = this.context.sources;
    if (watched === null) return;
    for (const bar of this.renderRoot.querySelectorAll<HTMLElement>(".bar")) {
      const at = watched.names.indexOf(bar.dataset.name ?? "");
      const [sent, weight] = [watched.sent[at] ?? 0, watched.weights[at] ?? 0];
      const [before, after] = bar.querySelectorAll("b") as unknown as [HTMLElement, HTMLElement];
      this.write.style(before, "transform", `scaleX(${clipped(sent)})`);
      this.write.style(after, "transform", `scaleX(${clipped(weight)})`);
      this.write.text(bar.lastElementChild as HTMLElement, String(Math.round(100 * weight)));
    }
  }
}

const clipped = (value: number): string => Math.min(1, Math.max(0, value)).toFixed(3);
