/** Where a macro plays at all: while something is above a level, or below it; it opens at one level and shuts at another. */

import { css, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { MacroCondition, MacroMapping } from "../../link/messages";
import { base, flow } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { MappingsElement } from "./mappings_element";
import type { NumberTyped } from "./number_field";
import "./number_field";

/** What a condition is from now on, null for none. */
export type ConditionChanged = CustomEvent<MacroCondition | null>;

const CHANNEL_LEVELS = { low: -1, high: 1.5 };

const style = css`
  .row {
    ${flow}
    gap: 6px 8px;
    align-items: end;
  }
  label {
    display: grid;
    gap: 2px;
    min-width: 0;
    font-size: 12px;
    color: var(--dim);
  }
  label:first-child {
    flex: 0 1 220px;
  }
  select {
    width: 100%;
    min-height: 28px;
  }
  omote-number-field {
    width: 92px;
  }
  @media (pointer: coarse) {
    select {
      min-height: var(--finger, 44px);
    }
  }
  .shows {
    padding-bottom: 6px;
  }
  .shows.shut {
    color: var(--attention);
  }
`;

/** Tells `condition`. */
@customElement("omote-condition-form")
export class ConditionForm extends MappingsElement {
  @property({ attribute: false }) mapping!: MacroMapping;

  static override styles = [base, style];

  override render() {
    const { when } = this.mapping;
    return html`<div class="row">
      <label>When<select name="reads" @change=${this.#choose}>
        <option value="" .selected=${when === null}>always</option>
        ${this.#choices().map(([reads, label]) => html`<option value=${reads} .selected=${when?.reads === reads}>${label}</option>`)}</select></label>
      ${when === null ? nothing : this.#levels(when)}
      <span class="shows" role="status"></span>
    </div>`;
  }

  #levels(when: MacroCondition) {
    const shuts = when.above ? when.level - when.hysteresis : when.level + when.hysteresis;
    const { low, high } = CHANNEL_LEVELS;
    const shutsLow = when.above ? when.level - 1 : when.level;
    const shutsHigh = when.above ? when.level : when.level + 1;
    return html`<label>is<select name="above" @change=${(event: Event) => this.#tell({ ...when, above: textOf(event) === "above" })}>
        <option value="above" .selected=${when.above}>above</option><option value="below" .selected=${!when.above}>below</option></select></label>
      <omote-number-field data-level="opens" label="opens at" unit="%" .scale=${100} .low=${low} .high=${high} .value=${when.level}
        @typed=${({ detail }: NumberTyped) => this.#tell({ ...when, level: detail })}></omote-number-field>
      <omote-number-field data-level="shuts" label="shuts at" unit="%" .scale=${100} .low=${shutsLow} .high=${shutsHigh} .value=${shuts}
        @typed=${({ detail }: NumberTyped) => this.#tell({ ...when, hysteresis: rounded(Math.abs(when.level - detail)) })}></omote-number-field>`;
  }

  /** What can be read: other macros, expressions as they are called, channels as their faders stand. */
  #choices(): (readonly [string, string])[] {
    const { store, mapping } = this;
    const macros = this.mappings.list.filter(({ name }) => name !== mapping.name);
    const { expressions } = store;
    const known = [
      ...macros.map(({ name }) => [`macro/${name}`, `macro ${name}`] as const),
      ...expressions.map(({ name, label }) => [`expression/${name}`, `${label}, as called`] as const),
      ...expressions
        .filter(({ kind }) => kind !== "neutral")
        .map(({ name, label }) => [`channel/${name}`, `${label}, by its fader`] as const),
    ];
    const read = mapping.when?.reads ?? "";
    return read === "" || known.some(([reads]) => reads === read) ? known : [[read, `${read} (not there)`], ...known];
  }

  readonly #choose = (event: Event): void => {
    const reads = textOf(event);
    const before = this.mapping.when ?? { level: 0.5, above: true, hysteresis: 0.05 };
    this.#tell(reads === "" ? null : { ...before, reads });
  };

  #tell(when: MacroCondition | null): void {
    const ordered = when === null ? null : orderedCondition(when);
    this.dispatchEvent(new CustomEvent("condition", { detail: ordered }));
  }

  override paint(now: number): void {
    const { air } = this.store;
    const share = air?.macros[this.mapping.name]?.share ?? 0;
    const moved = this.store.macro(this.mapping.name).value(now) !== 0 || share > 0;
    const text =
      this.mapping.when === null || !moved ? "" : share > 0.99 ? "It shows" : share < 0.01 ? "Shut now" : "…";
    const line = this.renderRoot.querySelector(".shows") as HTMLElement;
    this.write.text(line, text);
    this.write.flag(line, "shut", text === "Shut now");
  }
}

/** In the order in which the show tells it, so that both can be compared. */
const orderedCondition = ({ reads, level, above, hysteresis }: MacroCondition): MacroCondition => ({
  reads,
  level,
  above,
  hysteresis,
});

const rounded = (number: number): number => Math.round(number * 1e6) / 1e6;
