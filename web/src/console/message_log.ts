/** The log: what the crew must know of the show and what this console was told, the newest first, and what can be taken back. */

import { css, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { ShowNotices } from "../ui/show_notices";
import { base, selectable } from "../ui/theme";
import { ConsoleDialog, sheet } from "./controls/console_dialog";
import type { LogEntry, Topic } from "./store/page_store";

const style = css`
  section {
    grid-template-rows: auto auto minmax(0, 1fr) auto;
    width: min(640px, 100%);
  }
  ol {
    overflow: auto;
    ${selectable}
  }
  li {
    display: grid;
    grid-template-columns: 64px minmax(0, 1fr);
    padding: 5px 2px;
    border-top: 1px solid var(--line);
    overflow-wrap: anywhere;
  }
  time {
    color: var(--dim);
  }
  .attention {
    color: var(--attention);
  }
`;

/** Over everything else but panic. What stands in it has been read. Tells `close`. */
@customElement("omote-message-log")
export class MessageLog extends ConsoleDialog {
  protected override readonly first = "button.close";
  @property({ attribute: false }) notices!: ShowNotices;

  static override styles = [base, sheet, style];

  protected override readonly topics: readonly Topic[] = ["notice", "crew"];

  override updated(): void {
    this.notices.dismissAll(); // they stand here
  }

  override render() {
    const { history } = this.store;
    const [undo, redo] = [history.next("undo"), history.next("redo")];
    return html`<section class="panel" role="dialog" aria-modal="true" aria-label="Log">
      <h2>Log</h2>
      <div class="row">
        <button ?disabled=${undo === null} @click=${() => this.store.undo()}>Undo${undo === null ? "" : `: ${undo.what}`}</button>
        <button ?disabled=${redo === null} @click=${() => this.store.redo()}>Redo${redo === null ? "" : `: ${redo.what}`}</button>
      </div>
      <ol>${this.#all().map(({ time, text, tone }) => html`<li class=${tone}><time>${clockTime(time)}</time><span>${text}</span></li>`)}
        ${this.#all().length === 0 ? html`<li>Nothing was said yet.</li>` : nothing}</ol>
      <div class="row"><button class="close" @click=${this.close}>Close</button></div>
    </section>`;
  }

  #all(): readonly LogEntry[] {
    const notices = this.notices.all.map(({ time, text }) => ({ time: time * 1000, text, tone: "attention" as const }));
    return [...notices, ...this.store.logEntries].sort((a, b) => b.time - a.time);
  }
}

/** Hours, minutes and seconds, as a clock on the wall of this place. */
const clockTime = (time: number): string => new Date(time).toLocaleTimeString([], { hour12: false });
