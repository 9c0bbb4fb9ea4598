/** The console's help: its keys and conventions. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { curtain, keysPage } from "../ui/dialog_style";
import { base } from "../ui/theme";
import { ConsoleDialog } from "./controls/console_dialog";
import { HELP } from "./store/keys";

const style = css`
  :host {
    inset: 62px 0 0; /* panic stays in sight */
  }
  p {
    margin: 8px 0;
    color: var(--dim);
    max-width: 66ch;
  }
  .air {
    color: var(--air);
  }
  .coming {
    color: var(--coming);
  }
  .attention {
    color: var(--attention);
  }
`;

/** The keys and the conventions, over everything else but panic. */
@customElement("omote-help")
export class Help extends ConsoleDialog {
  static override styles = [base, curtain, keysPage, style];

  override render() {
    return html`<section class="panel" role="dialog" aria-modal="true" aria-label="Keys">
      <h2>Keys</h2>
      <dl>${HELP.map(([keys, does]) => html`<dt>${keys}</dt><dd>${does}</dd>`)}</dl>
      <h2>Conventions</h2>
      <p><b class="air">Red</b> is on air, <b class="coming">green</b> is coming, white is your hand, <b class="attention">yellow</b> wants attention. In preview, which is not on air, violet stands in the place of red.</p>
      <p>You look at the face: right on a pad is the character's left, so the face on screen turns towards your dot. R and L on faders and pads are the character's own sides.</p>
      <p>A T-bar takes a call over when its handle meets the call's value (pick-up). Drag with Shift for fine moves; twice on a control puts it to rest; the wheel steps.</p>
      <p>A name on a control is that of another console whose hand is on it, yellow where yours is too: who moved last has it. <i>Set-up</i> gives this console its name.</p>
      <p>With leases (<i>Set-up</i>) whoever touches a part first has it: its frame has the holder's colour and name. What another holds says so when you touch it; <i>Take over</i> beside those words makes it yours, and both read it.</p>
      <p>Beside the picture: <b>+</b> adds a character; a key for each says whom this console plays, with Shift several, <i>All</i> all of them. <i>Scene</i> (P) has places, entering and leaving, names, and what the picture holds. Panic is of those played here, <i>ALL</i> beside it of every character.</p>
      <p>A face or an expression of your own is edited, renamed and deleted by the menu of its tile: point at it and press ⋯, or hold a finger on it. <i>Log</i> shows what was said and what can be taken back.</p>
      <button @click=${this.close}>Close</button>
    </section>`;
  }
}
