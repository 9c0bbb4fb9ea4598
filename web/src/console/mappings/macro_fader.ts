/** The fader of a macro: -1..1, or 0..1 where it plays nothing below its middle. */

import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import { base } from "../../ui/theme";
import { fractionOf, type Range } from "../../ui/travel";
import { FaderElement } from "../controls/fader";
import { faderStyle } from "../controls/fader_style";
import { otherStyle, paintOther } from "../controls/other_hand";
import type { Knob } from "../store/knob";

const BOTH_WAYS: Range = { low: -1, high: 1 };
const ONE_WAY: Range = { low: 0, high: 1 };

const style = css`
  .middle {
    position: absolute;
    left: 50%;
    bottom: 50%;
    width: 24px;
    margin-left: -12px;
    height: 1px;
    background: var(--edge);
  }
  .slot:not(.both) .middle {
    display: none;
  }
  .fill {
    position: absolute;
    left: 50%;
    bottom: var(--rest, 0);
    width: 4px;
    height: 100%;
    margin-left: -2px;
    transform-origin: bottom;
    transform: scaleY(0);
    background: var(--air);
  }
  .number.moved {
    color: var(--hand);
  }
  .shut .fill {
    background: var(--dim);
  }
`;

/** The column is what a hand has given it; grey while its condition lets nothing of it show. */
@customElement("omote-macro-fader")
export class MacroFader extends FaderElement {
  @property() name = "";
  /** Whether it plays below its middle. */
  @property({ type: Boolean }) both = false;

  static override styles = [base, faderStyle, style, otherStyle];
  protected override readonly stops = [0];

  override range: Range = ONE_WAY;

  /** It is another element where its range is another. */
  override willUpdate(): void {
    this.range = this.both ? BOTH_WAYS : ONE_WAY;
  }

  override render() {
    return html`<div class="number"></div>
      <div class="slot ${this.both ? "both" : ""}" role="slider" tabindex="0" aria-orientation="vertical" aria-valuemin=${this.range.low} aria-valuemax="1"
        aria-label="Macro ${this.name}" data-macro=${this.name} style="--rest:${this.both ? "50%" : "0"}">
        <div class="middle"></div>
        <div class="groove"></div>
        <div class="fill"></div>
        <div class="carrier"></div>
        <span class="other"></span>
      </div>`;
  }

  protected override get knob(): Knob {
    return this.store.macro(this.name);
  }

  protected override rest(): void {
    this.knob.nudge(0);
  }

  paint(now: number): void {
    const { air } = this.store;
    if (air === null || this.offsetParent === null) return;
    const { write, knob, range } = this;
    const value = knob.value(now);
    write.style(this.carrier, "transform", `translateY(${-100 * fractionOf(value, range)}%)`);
    const fill = this.slotElement.querySelector(".fill") as HTMLElement;
    write.style(fill, "transform", `scaleY(${(value / (range.high - range.low)).toFixed(4)})`);
    write.flag(this.slotElement, "shut", value !== 0 && (air.macros[this.name]?.share ?? 1) < 0.01);
    write.text(this.number, String(Math.round(100 * value)));
    write.flag(this.number, "moved", value !== 0);
    write.attribute(this.slotElement, "aria-valuenow", value.toFixed(2));
    paintOther(write, this.other, this.store, knob, now);
  }
}
