/** Who plays the character beside the hands at this page: a hand or a face before a camera, a voice, a program. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { base, ellipsis } from "../../ui/theme";
import { ConsoleElement } from "../controls/console_element";
import type { Topic } from "../store/page_store";
import { playersWords } from "./player_words";

const style = css`
  :host {
    ${ellipsis}
    font-size: 11px;
    color: var(--dim);
  }
  :host([none]) {
    display: none;
  }
`;

@customElement("omote-source-line")
export class SourceLine extends ConsoleElement {
  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["sources", "characters", "link"];

  override render() {
    const words = playersWords(this.store.sources, this.store.played.lead);
    this.toggleAttribute("none", words === "");
    this.title = words;
    return html`${words}`;
  }
}
