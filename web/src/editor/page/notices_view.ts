/** The notices that must be read, with what can be done about them. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { base, notice as box, wanted } from "../../ui/theme";
import { controls } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import type { Topic } from "../session/draft_store";
import type { EditorNotice } from "../session/notices";

/** Milliseconds for which good news stands. */
const SEEN = 12_000;

const style = css`
  :host {
    display: grid;
    grid-template-columns: minmax(0, 1fr);
    gap: 6px;
  }
  :host([hidden]) {
    display: none;
  }
  [role] {
    ${box}
    align-items: start;
    padding: 6px 6px 8px 12px;
    background: #1d2126;
    border: 1px solid var(--edge);
  }
  .refusal,
  .conflict {
    ${wanted}
  }
  .done {
    border-color: var(--coming);
    background: #0d2417;
  }
  span {
    padding-top: 5px;
  }
  .row {
    grid-column: 1 / -1;
  }
`;

/** What must be read. */
@customElement("omote-notices")
export class NoticesView extends EditorElement {
  static override styles = [base, controls, style];

  readonly #timers = new Map<number, ReturnType<typeof setTimeout>>();

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const timer of this.#timers.values()) clearTimeout(timer);
  }

  /** Good news goes by itself; what went wrong stays until it has been read. */
  override willUpdate(): void {
    for (const { id, kind } of this.store.notices) {
      if (kind !== "done" || this.#timers.has(id)) continue;
      this.#timers.set(
        id,
        setTimeout(() => this.store.dismiss(id), SEEN),
      );
    }
  }

  /** Nothing to say takes no room. */
  override updated(): void {
    this.hidden = this.store.notices.length === 0;
  }

  protected override readonly topics: readonly Topic[] = ["notices"];

  override render() {
    return repeat(
      this.store.notices,
      ({ id }) => id,
      (notice) => this.#notice(notice),
    );
  }

  #button(id: number, { label, act }: EditorNotice["actions"][number]) {
    return html`<button @click=${() => {
      this.store.dismiss(id);
      act();
    }}>${label}</button>`;
  }

  #notice({ id, text, kind, actions }: EditorNotice) {
    return html`<div class=${kind} role=${kind === "done" ? "status" : "alert"}>
      <span>${text}</span>
      <button class="icon quiet" title="I have read it" aria-label="Dismiss" @click=${() => this.store.dismiss(id)}>✕</button>
      ${actions.length === 0 ? nothing : html`<div class="row">${actions.map((action) => this.#button(id, action))}</div>`}
    </div>`;
  }
}
