/** The editor's help: its keys and words. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { curtain, keysPage } from "../../ui/dialog_style";
import { layerWhileShown } from "../../ui/key_presses";
import { base } from "../../ui/theme";
import { controls } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import { HELP } from "./keys";

const style = css`
  p {
    margin: 8px 0;
  }
`;

/** The keys and the words of the editor, over everything else. Tells `close`. */
@customElement("omote-editor-help")
export class EditorHelp extends EditorElement {
  static override styles = [base, controls, curtain, keysPage, style];

  constructor() {
    super();
    layerWhileShown(this, "dialog", this.close);
  }

  override firstUpdated(): void {
    this.renderRoot.querySelector("button")?.focus();
  }

  override render() {
    return html`<section class="panel" role="dialog" aria-modal="true" aria-label="Keys">
      <h2>Keys</h2>
      <dl>${HELP.map(([keys, does]) => html`<dt>${keys}</dt><dd>${does}</dd>`)}</dl>
      <h2>Words</h2>
      <p>An expression belongs to no face. Each needle says how a point of the skin turns around the head, rises, and goes out or in; every face makes of it what suits its own shape.</p>
      <p>Your draft is kept with every step; Save makes a revision of it, and that is what the console plays. Nothing saved is ever replaced: History brings back any of it.</p>
      <p>Left and right are the character's own: its left is on the right of the picture.</p>
      <button @click=${this.close}>Close</button>
    </section>`;
  }
}
