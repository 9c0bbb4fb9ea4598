/** The log: what the crew must know of the show and what this console was told, the newest first, and what can be taken back. */

import { css, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import { closeOutside, curtainBelowBar } from "../ui/dialog_style";
import { layerWhileShown } from "../ui/key_presses";
import type { ShowNotices } from "../ui/show_notices";
import { base } from "../ui/theme";
import { ConsoleElement } from "./controls/console_element";
import type { Told, Topic } from "./store/page_store";

/** Over everything else but panic. What stands in it has been read. Tells `close`. */
@customElement("omote-message-log")
export class MessageLog extends ConsoleElement {
  @property({ attribute: false }) notices!: ShowNotices;

  static override styles = [
    base,
    curtainBelowBar,
    css`
      section {
        display: grid;
        grid-template-rows: auto auto minmax(0, 1fr) auto;
        gap: 10px;
        width: min(640px, 100%);
        max-height: 100%;
        padding: 16px 18px;
      }
      .row {
        display: flex;
        flex-wrap: wrap;
        gap: 6px;
      }
      ol {
        margin: 0;
        padding: 0;
        overflow: auto;
        list-style: none;
        user-select: text;
        -webkit-user-select: text;
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
    `,
  ];

  constructor() {
    super();
    closeOutside(this, this.#close);
    layerWhileShown(this, "dialog", this.#close);
  }

  protected override topics(): readonly Topic[] {
    return ["notice", "crew"];
  }

  override firstUpdated(): void {
    this.renderRoot.querySelector<HTMLElement>("button.close")?.focus();
  }

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
      <div class="row"><button class="close" @click=${this.#close}>Close</button></div>
    </section>`;
  }

  #all(): readonly Told[] {
    const notices = this.notices.all.map(({ time, text }) => ({ time: time * 1000, text, tone: "attention" as const }));
    return [...notices, ...this.store.told].sort((a, b) => b.time - a.time);
  }

  readonly #close = (): void => {
    this.dispatchEvent(new CustomEvent("close"));
  };
}

/** Hours, minutes and seconds, as a clock on the wall of this place. */
const clockTime = (time: number): string => new Date(time).toLocaleTimeString([], { hour12: false });
