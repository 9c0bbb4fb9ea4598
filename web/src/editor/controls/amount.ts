/** A slider with a field for one number. */

import { css, html, LitElement } from "lit";
import { customElement, property } from "lit/decorators.js";
import { live } from "lit/directives/live.js";
import { base } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { controls } from "./controls_style";
import { shown, typed, type Unit } from "./units";

const style = css`
  :host {
    display: grid;
    grid-template-columns: minmax(44px, 1fr) minmax(40px, 0.9fr) 50px 12px;
    align-items: center;
    gap: 6px;
  }
  label {
    overflow: hidden;
    text-overflow: ellipsis;
    font-size: 12.5px;
  }
  input[type="text"] {
    text-align: right;
    padding: 0 5px;
    min-height: 26px;
  }
  .unit {
    color: var(--faint);
    font-size: 11px;
  }
`;

/** One number with its name: a slider, and a field for typing. Tells `live` while it moves and `done` when it rests. */
@customElement("omote-amount")
export class Amount extends LitElement {
  @property() label = "";
  @property() hint = "";
  @property({ attribute: false }) unit!: Unit;
  /** All three in the field's units, not in the shown one. */
  @property({ type: Number }) value = 0;
  @property({ type: Number }) low = 0;
  @property({ type: Number }) high = 1;
  /** Where a double-click puts it. */
  @property({ type: Number }) rest = 0;
  @property({ type: Boolean }) disabled = false;

  static override styles = [base, controls, style];

  override render() {
    const { unit } = this;
    const step = 10 ** -Math.min(unit.decimals, 2);
    return html`
      <label for="slide" title=${this.hint}>${this.label}</label>
      <input id="slide" type="range" title=${this.hint} ?disabled=${this.disabled}
        min=${this.low * unit.per} max=${this.high * unit.per} step=${step} .value=${String(this.value * unit.per)}
        aria-valuetext="${shown(this.value, unit)} ${unit.name}"
        @input=${(event: Event) => this.#tell("live", Number(textOf(event)) / unit.per)}
        @change=${(event: Event) => this.#tell("done", Number(textOf(event)) / unit.per)}
        @dblclick=${() => this.#tell("done", Math.max(this.low, Math.min(this.high, this.rest)))} />
      <input type="text" inputmode="decimal" aria-label="${this.label}, ${unit.name}" ?disabled=${this.disabled}
        .value=${live(shown(this.value, unit))} @change=${this.#type} />
      <span class="unit">${unit.name}</span>
    `;
  }

  readonly #type = (event: Event): void => {
    const field = event.target as HTMLInputElement;
    const value = typed(field.value, this.unit);
    if (value === null) field.value = shown(this.value, this.unit);
    else this.#tell("done", value);
  };

  #tell(what: "live" | "done", value: number): void {
    this.value = value;
    this.dispatchEvent(new CustomEvent(what, { detail: value }));
  }
}

/** The number that a `live` or `done` carries. */
export const amountOf = (event: Event): number => (event as CustomEvent<number>).detail;

/** The number that a `done` carries, brought between limits; the field shows it so. */
export function amountWithin(event: Event, least: number, most: number): number {
  const field = event.currentTarget as Amount;
  field.value = Math.min(most, Math.max(least, amountOf(event)));
  return field.value;
}
