/** How much the character moves by itself: lids, eyes and the head that follows them, breath and small noise. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { base } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { AnimatedElement } from "../controls/console_element";
import { otherStyle, paintOther } from "../controls/other_hand";
import { type MotionDetail, STILL } from "../store/knob";
import { GazeTargetCommands } from "./gaze_target_commands";

/** What each slider sets: its label, where it ends, and in words. */
const SLIDERS: readonly (readonly [MotionDetail, string, number, string])[] = [
  ["liveliness", "Liveliness", 1, "0 holds it still, 50 is as people move; drives the layers blink, gaze and breath"],
  ["blinks", "Blink rate", 2, "How often lids close beside that; 100 as people's do"],
  ["gaze", "Eye travel", 2, "How far the eyes wander, and the head with them"],
  ["breath", "Breath depth", 2, "How deep it breathes, and how much it trembles"],
];

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
  .idle {
    grid-column: 1 / -1;
    min-height: 30px;
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
  }
  @media (pointer: coarse) {
    .way,
    .idle {
      min-height: var(--finger);
    }
  }
  .number {
    text-align: right;
    color: var(--dim);
  }
`;

@customElement("omote-motion-settings")
export class MotionSettings extends AnimatedElement {
  static override styles = [base, style, otherStyle];

  override render() {
    return html`${SLIDERS.map(
      ([detail, label, most, title]) =>
        html`<label title=${title}><span>${label}</span>
            <span class="way"><input type="range" name=${detail} min="0" max=${most} step="0.05"
              @input=${(event: Event) => this.#set(detail, event)} @change=${() => this.store.motion(detail).leave()}
              @dblclick=${() => this.store.motion(detail).nudge(STILL[detail])} /><span class="other"></span></span>
            <span class="number"></span></label>`,
    )}
      <button class="idle" aria-pressed="false" @click=${this.#idle}
        title="Where it holds still otherwise, it moves as people do until its tracker is back">Idles when its tracker is lost</button>`;
  }

  #set(detail: MotionDetail, event: Event): void {
    this.store.motion(detail).grip(Number(textOf(event)));
  }

  readonly #idle = (): void => {
    new GazeTargetCommands(this.store).idle(!(this.store.air?.motion?.idle ?? false));
  };

  paint(now: number): void {
    const { air } = this.store;
    if (air === null || this.offsetParent === null) return;
    const idle = this.renderRoot.querySelector(".idle") as HTMLElement;
    this.write.attribute(idle, "aria-pressed", String(air.motion?.idle ?? false));
    for (const input of this.renderRoot.querySelectorAll("input")) this.#paintSlider(input, now);
  }

  #paintSlider(input: HTMLInputElement, now: number): void {
    const knob = this.store.motion(input.name as MotionDetail);
    const value = knob.value(now);
    if (!knob.gripped() && Number(input.value) !== value) input.value = String(value);
    const [way, write] = [input.parentElement as HTMLElement, this.write];
    write.text(way.nextElementSibling as HTMLElement, String(Math.round(100 * value)));
    write.attribute(input, "aria-valuetext", `${Math.round(100 * value)} percent`);
    paintOther(write, way.querySelector(".other") as HTMLElement, this.store, knob, now);
  }
}
