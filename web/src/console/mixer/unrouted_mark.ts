/** How many sources play nobody, as a mark on what opens the mixer, where each is given a character. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { ConsoleElement } from "../controls/console_element";
import type { Topic } from "../store/page_store";
import { countUnrouted, unrouted } from "./unrouted_sources";

@customElement("omote-unrouted-mark")
export class UnroutedMark extends ConsoleElement {
  static override styles = css`
    i {
      display: inline-block;
      min-width: 14px;
      margin-left: 4px;
      padding: 0 3px;
      border-radius: 7px;
      background: var(--attention);
      color: #000;
      font: 700 11px/14px system-ui, sans-serif;
    }
  `;

  protected override readonly topics: readonly Topic[] = ["sources"];

  override render() {
    const count = unrouted(this.store.sources).length;
    const what = countUnrouted(count);
    return count === 0 ? nothing : html`<i role="img" aria-label=${what} title=${what}>${count}</i>`;
  }
}
