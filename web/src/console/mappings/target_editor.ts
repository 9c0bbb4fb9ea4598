/** One target of a macro: its curves, its range, how it follows, and what it gives now. */

import { css, html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { LONGEST_FOLLOWER, MOST_KNOTS } from "../../link/constants";
import type { MacroMapping, MacroTarget } from "../../link/messages";
import { base, flow } from "../../ui/theme";
import {
  drawnRange,
  type Half,
  halfOf,
  mirrored,
  rangeOf,
  reading,
  scaleOf,
  targetAt,
  targetLabel,
  unitOf,
} from "./macro_targets";
import { MappingsElement } from "./mappings_element";
import { STRAIGHT } from "./monotone_curve";
import type { NumberTyped } from "./number_field";
import type { CurveChanged, TargetCurve } from "./target_curve";
import "./number_field";
import "./target_curve";

/** What a target is from now on, null for none; `over`: a hand has let go of it; `what` was changed, for people. */
export type TargetChanged = CustomEvent<{
  readonly target: MacroTarget | null;
  readonly over: boolean;
  readonly what: string;
}>;

const style = css`
  :host {
    padding: 8px 10px;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--raised);
  }
  header,
  .keys {
    ${flow}
    gap: 4px 8px;
  }
  header b {
    overflow-wrap: anywhere;
  }
  header .gives {
    margin-left: auto;
    font-weight: 700;
    color: var(--air);
  }
  .missing {
    flex: 1 1 100%;
    color: var(--attention);
  }
  .drawn {
    display: grid;
    grid-template-columns: 40px minmax(0, 1fr);
  }
  .scale {
    display: flex;
    flex-direction: column;
    justify-content: space-between;
    height: 142px;
    font-size: 11px;
    text-align: right;
    color: var(--dim);
  }
  .halves {
    display: grid;
    grid-auto-flow: column;
    grid-auto-columns: minmax(0, 1fr);
  }
  .fields {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(60px, 1fr));
    gap: 6px 8px;
    margin: 4px 0 6px;
    align-items: start;
  }
  button:not([aria-pressed="true"]) {
    color: var(--text);
  }
`;

/** Tells `target`. */
@customElement("omote-target-editor")
export class TargetEditor extends MappingsElement {
  @property({ attribute: false }) mapping!: MacroMapping;
  @property({ attribute: false }) target!: MacroTarget;
  @query(".gives") private gives!: HTMLElement;
  /** The half that was touched last: its knots come and go by the keys below. */
  @state() private half: Half = "above";

  static override styles = [base, style];

  override render() {
    const { target } = this;
    const { below } = target;
    const drawn = drawnRange(target);
    const knots = this.#shape.length;
    const missing = this.mappings.missing.includes(target.to);
    return html`<header><b>${this.#label}</b><span class="gives"></span>
        <button data-remove aria-label="Take ${this.#label} away" title="The macro does not play it any more" ?disabled=${this.mapping.targets.length === 1} @click=${() => this.#tell(null, `${this.#label} taken away`)}>×</button>
        ${missing ? html`<span class="missing">${target.to} is not there: it gives nothing.</span>` : nothing}</header>
      <div class="drawn"><div class="scale"><span>${reading(target.to, drawn.high)}</span><span>${reading(target.to, drawn.low)}</span></div>
        <div class="halves">${below === null ? nothing : this.#curve("below")}${this.#curve("above")}</div></div>
      <div class="fields">
        ${below === null ? nothing : this.#field("at −100", below.high, (high) => ({ below: { ...below, high } }))}
        ${this.#field("at 0", target.low, (low) => ({ low }))} ${this.#field("at 100", target.high, (high) => ({ high }))}
        ${this.#seconds("Rise", target.rise, (rise) => ({ rise }))} ${this.#seconds("Fall", target.fall, (fall) => ({ fall }))}
      </div>
      <div class="keys">
        <button data-add title="One more knot in the widest gap; or press twice on the curve" ?disabled=${knots >= MOST_KNOTS} @click=${() => this.#drawn.addKnot()}>+ knot</button>
        <button data-less title="The chosen knot away (Delete)" ?disabled=${knots <= 2} @click=${() => this.#drawn.removeKnot()}>− knot</button>
        <button data-both aria-pressed=${below !== null} title="What it gives below zero, apart" @click=${this.#toggleBelow}>Below zero</button>
        <button data-mirror title="The other way round" @click=${() => this.#tell(mirrored(target), `${this.#label} mirrored`)}>Mirror</button>
      </div>`;
  }

  get #label(): string {
    return targetLabel(this.target.to, (name) => this.store.label("expression", name));
  }

  get #shape() {
    return (halfOf(this.target, this.half) ?? this.target).curve;
  }

  get #drawn(): TargetCurve {
    const curve = (half: Half) => this.renderRoot.querySelector<TargetCurve>(`omote-target-curve[half=${half}]`);
    return curve(this.half) ?? (curve("above") as TargetCurve);
  }

  #curve(half: Half) {
    return html`<omote-target-curve .context=${this.context} .target=${this.target} half=${half} .macro=${this.mapping.name}
      .label=${this.#label} @focusin=${() => (this.half = half)} @curve=${this.#bend}></omote-target-curve>`;
  }

  #field(label: string, value: number, change: (value: number) => Partial<MacroTarget>) {
    const { to } = this.target;
    const { low, high } = rangeOf(to);
    return html`<omote-number-field .label=${label} .unit=${unitOf(to)} .scale=${scaleOf(to)} .digits=${1} .low=${low} .high=${high} .value=${value}
      @typed=${({ detail }: NumberTyped) => this.#tell({ ...this.target, ...change(detail) }, `${this.#label} ${label}`)}></omote-number-field>`;
  }

  #seconds(label: string, value: number, change: (value: number) => Partial<MacroTarget>) {
    return html`<omote-number-field .label=${label} unit="s" .digits=${2} .high=${LONGEST_FOLLOWER} .value=${value}
      @typed=${({ detail }: NumberTyped) => this.#tell({ ...this.target, ...change(detail) }, `${label.toLowerCase()} of ${this.#label}`)}></omote-number-field>`;
  }

  readonly #bend = ({ detail }: CurveChanged): void => {
    this.#tell(detail.target, `curve of ${this.#label}`, detail.over);
  };

  /** A half of its own begins as the other one, the other way; without one the target rests below zero. */
  readonly #toggleBelow = (): void => {
    const { target } = this;
    const { low, high } = rangeOf(target.to);
    const end = Math.min(high, Math.max(low, 2 * target.low - target.high));
    const curve = STRAIGHT.map(([at, gives]): [number, number] => [at, gives]);
    const below = target.below === null ? { high: end, curve } : null;
    this.#tell({ ...target, below }, `half below zero of ${this.#label}`);
  };

  #tell(target: MacroTarget | null, what: string, over = true): void {
    this.dispatchEvent(new CustomEvent("target", { detail: { target, over, what } }));
  }

  override paint(now: number): void {
    const value = this.store.macro(this.mapping.name).value(now);
    this.write.text(this.gives, reading(this.target.to, targetAt(this.target, value)));
  }
}
