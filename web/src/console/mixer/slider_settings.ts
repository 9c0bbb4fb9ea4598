/** Settings of a character as sliders with their percents, one below the other. */

import { css, html } from "lit";
import { textOf } from "../../ui/topic_element";
import { AnimatedElement } from "../controls/console_element";
import { otherStyle, paintOther } from "../controls/other_hand";
import type { Knob } from "../store/knob";

/** What a slider sets, by name; `most`: where it ends; `rest`: where a double-click puts it. */
export interface Setting<Name extends string> {
  readonly name: Name;
  readonly label: string;
  readonly title: string;
  readonly most: number;
  readonly rest: number;
}

const style = css`
  :host {
    display: grid;
    grid-template-columns: auto minmax(40px, 1fr) 28px;
    align-items: center;
    align-content: start;
    gap: 2px 8px;
    flex: none;
    font-size: 12px;
  }
  label {
    display: contents;
  }
  .way {
    position: relative;
    display: grid;
    min-height: 21px;
  }
  input[type="range"] {
    width: 100%;
  }
  @media (pointer: coarse) {
    .way {
      min-height: var(--finger);
    }
  }
  .number {
    text-align: right;
    color: var(--dim);
  }
`;

export const sliderStyle = [style, otherStyle];

export abstract class SliderSettings<Name extends string> extends AnimatedElement {
  /** What a slider moves. */
  protected abstract knob(name: Name): Knob;

  protected slider({ name, label, title, most, rest }: Setting<Name>) {
    const knob = (): Knob => this.knob(name);
    return html`<label title=${title}><span>${label}</span>
      <span class="way"><input type="range" name=${name} min="0" max=${most} step="0.05"
        @input=${(event: Event) => knob().grip(Number(textOf(event)))} @change=${() => knob().leave()}
        @dblclick=${() => knob().nudge(rest)} /><span class="other"></span></span>
      <span class="number"></span></label>`;
  }

  paint(now: number): void {
    if (this.store.air === null || this.offsetParent === null) return;
    for (const input of this.renderRoot.querySelectorAll("input")) this.#paintSlider(input, now);
  }

  #paintSlider(input: HTMLInputElement, now: number): void {
    const knob = this.knob(input.name as Name);
    const value = knob.value(now);
    if (!knob.gripped() && Number(input.value) !== value) input.value = String(value);
    const [way, write] = [input.parentElement as HTMLElement, this.write];
    write.text(way.nextElementSibling as HTMLElement, String(Math.round(100 * value)));
    write.attribute(input, "aria-valuetext", `${Math.round(100 * value)} percent`);
    paintOther(write, way.querySelector(".other") as HTMLElement, this.store, knob, now);
  }
}
