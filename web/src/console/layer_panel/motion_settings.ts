/** How much the character moves by itself: lids, eyes and the head that follows them, breath and small noise. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { base } from "../../ui/theme";
import { AnimatedElement, StyleWriter } from "../controls/console_element";
import { otherStyle, paintOther } from "../controls/other_hand";
import { type MotionDetail, STILL } from "../store/knob";

/** What each slider sets: its label, where it ends, and in words. */
const SLIDERS: readonly (readonly [MotionDetail, string, number, string])[] = [
  ["liveliness", "Liveliness", 1, "0 holds it still, 50 is as people move; drives the layers blink, gaze and breath"],
  ["blinks", "Blinks", 2, "How often lids close beside that; 100 as people's do"],
  ["gaze", "Gaze", 2, "How far the eyes wander, and the head with them"],
  ["breath", "Breath", 2, "How deep it breathes, and how much it trembles"],
];

@customElement("omote-motion-settings")
export class MotionSettings extends AnimatedElement {
  readonly #written = new StyleWriter();

  static override styles = [
    base,
    css`
      :host {
        display: grid;
        grid-template-columns: repeat(2, auto minmax(40px, 1fr) 24px);
        align-items: center;
        gap: 2px 8px;
        flex: none;
        font-size: 12px;
      }
      h3 {
        grid-column: 1 / -1;
        margin: 0;
        font-size: 12px;
        color: var(--dim);
      }
      label {
        display: contents;
      }
      .way {
        position: relative;
        display: grid;
        min-height: 24px;
      }
      input[type="range"] {
        width: 100%;
        min-width: 0;
        margin: 0;
        accent-color: var(--hand);
      }
      @media (pointer: coarse) {
        .way {
          min-height: 44px;
        }
      }
      .number {
        text-align: right;
        color: var(--dim);
        font-variant-numeric: tabular-nums;
      }
    `,
    otherStyle,
  ];

  override render() {
    return html`<h3>Moves by itself</h3>
      ${SLIDERS.map(
        ([detail, label, most, title]) =>
          html`<label title=${title}><span>${label}</span>
            <span class="way"><input type="range" name=${detail} min="0" max=${most} step="0.05"
              @input=${(event: Event) => this.#set(detail, event)} @change=${() => this.store.motion(detail).leave()}
              @dblclick=${() => this.store.motion(detail).nudge(STILL[detail])} /><span class="other"></span></span>
            <span class="number"></span></label>`,
      )}`;
  }

  #set(detail: MotionDetail, event: Event): void {
    this.store.motion(detail).grip(Number((event.target as HTMLInputElement).value));
  }

  paint(now: number): void {
    if (this.store.air === null || this.offsetParent === null) return;
    for (const input of this.renderRoot.querySelectorAll("input")) this.#paintSlider(input, now);
  }

  #paintSlider(input: HTMLInputElement, now: number): void {
    const knob = this.store.motion(input.name as MotionDetail);
    const value = knob.value(now);
    if (!knob.gripped() && Number(input.value) !== value) input.value = String(value);
    const [way, write] = [input.parentElement as HTMLElement, this.#written];
    write.text(way.nextElementSibling as HTMLElement, String(Math.round(100 * value)));
    write.attribute(input, "aria-valuetext", `${Math.round(100 * value)} percent`);
    paintOther(write, way.querySelector(".other") as HTMLElement, this.store, knob, now);
  }
}
