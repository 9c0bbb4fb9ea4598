/** The line of notes of the crew: it stands in the bar while nothing else is said there. */

import { css, html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { base, ellipsis, entry } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { ConsoleElement } from "../controls/console_element";
import type { Topic } from "../store/page_store";

/** Letters of a note (`LONGEST_NOTE` of the show). */
const LONGEST = 200;

const style = css`
  :host {
    flex: 1;
    min-width: 0;
  }
  button {
    max-width: 100%;
    min-height: 28px;
    padding: 0 6px;
    border: 0;
    background: none;
    color: var(--text);
    font-size: 12.5px;
    ${ellipsis}
  }
  button.empty {
    color: var(--dim);
  }
  input {
    ${entry}
    width: 100%;
    min-height: 28px;
  }
  @media (pointer: coarse) {
    button,
    input {
      min-height: 40px;
      min-width: 40px;
    }
  }
`;

@customElement("omote-note")
export class NoteLine extends ConsoleElement {
  @state() private editing = false;
  @query("input") private field!: HTMLInputElement | null;
  /** The note of the last state that was heard; null before there is one. */
  #shown: string | null = null;

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["state"];

  /** States come sixty times a second. */
  protected override changed(): void {
    const note = this.store.state?.note ?? null;
    if (note !== this.#shown) this.requestUpdate();
    this.#shown = note;
  }

  override render() {
    const { note = "" } = this.store.state ?? {};
    if (this.editing)
      return html`<input aria-label="Note for the crew" maxlength=${LONGEST} .value=${note} autocomplete="off"
        @keydown=${this.#key} @blur=${this.#end} />`;
    if (this.store.state === null) return nothing;
    return html`<button class=${note === "" ? "empty" : ""} title="A line that every console shows; press to write it"
      @click=${this.#edit}>${note === "" ? "Note" : note}</button>`;
  }

  readonly #edit = async (): Promise<void> => {
    this.editing = true;
    await this.updateComplete;
    this.field?.focus();
    this.field?.select();
  };

  readonly #key = (event: KeyboardEvent): void => {
    if (event.key === "Enter" && !event.isComposing) this.field?.blur();
  };

  readonly #end = (event: Event): void => {
    if (!this.editing) return;
    this.editing = false;
    const [before, text] = [this.store.state?.note ?? "", textOf(event).trim()];
    if (text === before) return;
    const to = (words: string) => [{ type: "set_note", text: words }] as const;
    this.store.act("The note is on every console.", { what: "note", undo: to(before), redo: to(text) });
  };
}
