/** The time of day, and the time since the show began. */

import { css, html } from "lit";
import { customElement, query } from "lit/decorators.js";
import { clockOf, sinceOf } from "../../ui/show_times";
import { base } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";

const style = css`
  :host {
    flex: none;
    display: flex;
    align-items: baseline;
    gap: 6px;
    font-size: 12px;
    color: var(--dim);
  }
  b {
    color: var(--text);
    font-weight: 600;
  }
  button {
    min-height: 28px;
    padding: 0 4px;
    border: 0;
    background: none;
    color: var(--text);
    font-size: 12px;
  }
  @media (pointer: coarse) {
    button {
      min-height: 40px;
      min-width: 40px;
    }
  }
`;

/** A press on the time since the show began begins it anew; *Undo* puts it back. */
@customElement("omote-show-clock")
export class ShowClock extends AnimatedElement {
  @query("b") private day!: HTMLElement;
  @query("button") private since!: HTMLElement;

  static override styles = [base, style];

  override render() {
    return html`<b aria-label="Time of day"></b>
      <button title="Since the show began. Press: it begins now" @click=${this.#begin}></button>`;
  }

  readonly #begin = (): void => {
    const { state } = this.store;
    if (state === null) return;
    const step = { undo: [{ type: "begin_show", at: state.began }], redo: [{ type: "begin_show" }] } as const;
    this.store.act("The show begins now.", { what: "beginning of the show", ...step });
  };

  paint(): void {
    const { state } = this.store;
    this.write.text(this.day, clockOf(new Date()));
    const since = state === null ? "" : sinceOf(state.time - state.began);
    this.write.text(this.since, since);
    this.write.attribute(this.since, "aria-label", `${since} since the show began`);
  }
}
