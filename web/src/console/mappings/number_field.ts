/** A field for a number: one that cannot be is said below it, and changes nothing. */

import { css, html, LitElement, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { base, entry } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";

export type NumberTyped = CustomEvent<number>;

const style = css`
  :host {
    display: inline-block;
    min-width: 0;
  }
  label {
    display: grid;
    gap: 2px;
    font-size: 12px;
    color: var(--dim);
  }
  input {
    ${entry}
    width: 100%;
    min-height: 28px;
  }
  input[aria-invalid="true"] {
    border-color: var(--attention);
  }
  .wrong {
    color: var(--attention);
    max-width: 22ch;
  }
`;

/** Tells `typed` with a number in the unit of what it is of. */
@customElement("omote-number-field")
export class NumberField extends LitElement {
  @property() label = "";
  /** In its own unit, as `low` and `high`. */
  @property({ type: Number }) value = 0;
  @property({ type: Number }) low = 0;
  @property({ type: Number }) high = 1;
  /** How many of what is typed one of that is, and what stands behind it. */
  @property({ type: Number }) scale = 1;
  @property() unit = "";
  @property({ type: Number }) digits = 0;
  @state() private wrong = "";

  static override styles = [base, style];

  override willUpdate(changed: Map<PropertyKey, unknown>): void {
    if (changed.has("value")) this.wrong = "";
  }

  override render() {
    const { wrong } = this;
    return html`<label>${this.label}${this.unit === "" ? "" : ` (${this.unit})`}
      <input inputmode="decimal" .value=${this.#text(this.value)} aria-invalid=${wrong !== ""} @change=${this.#read} />
      ${wrong === "" ? nothing : html`<span class="wrong" role="alert">${wrong}</span>`}</label>`;
  }

  #text(value: number): string {
    return String(Number((value * this.scale).toFixed(this.digits)));
  }

  readonly #read = (event: Event): void => {
    const typed = textOf(event).trim().replace(",", ".");
    const shown = Number(typed);
    const [least, most] = [this.#text(this.low), this.#text(this.high)];
    const ok = typed !== "" && Number.isFinite(shown) && shown >= Number(least) && shown <= Number(most);
    this.wrong = ok ? "" : `${typed === "" ? "Nothing" : typed} cannot be: give ${least} to ${most}.`;
    if (!ok) return;
    const value = Math.min(this.high, Math.max(this.low, shown / this.scale));
    this.dispatchEvent(new CustomEvent("typed", { detail: value }));
  };
}
