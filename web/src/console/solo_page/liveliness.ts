/** How much the characters that are played move by themselves: a slider, and one press that holds them still. */

import { css, html } from "lit";
import { customElement, query } from "lit/decorators.js";
import { base } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { AnimatedElement } from "../controls/console_element";
import { otherStyle, paintOther } from "../controls/other_hand";
import type { Knob } from "../store/knob";
import { isStill, toggleStill } from "../store/stillness";

const style = css`
  :host {
    display: flex;
    align-items: center;
    gap: 6px;
    min-width: 0;
  }
  .way {
    position: relative;
    display: var(--way, grid);
    min-width: 60px;
    width: 110px;
  }
  input {
    width: 100%;
    min-height: 34px;
  }
  button {
    min-height: 34px;
  }
`;

@customElement("omote-liveliness")
export class Liveliness extends AnimatedElement {
  @query("input") private slider!: HTMLInputElement;
  @query("button") private still!: HTMLElement;
  @query(".other") private other!: HTMLElement;

  static override styles = [base, style, otherStyle];

  override render() {
    return html`<span class="way"><input type="range" aria-label="Liveliness" title="Liveliness: 0 holds it still, 0.5 is as people move" min="0" max="1" step="0.05"
        @input=${(event: Event) => this.#knob.grip(Number(textOf(event)))} @change=${() => this.#knob.leave()} /><span class="other"></span></span>
      <button aria-pressed="false" title="Holds still; else it blinks, breathes and looks about as people do (')" @click=${() => toggleStill(this.store)}>Still</button>`;
  }

  get #knob(): Knob {
    return this.store.motion("liveliness");
  }

  paint(now: number): void {
    const value = String(this.#knob.value(now));
    if (!this.#knob.gripped() && this.slider.value !== value) this.slider.value = value;
    this.write.attribute(this.still, "aria-pressed", String(isStill(this.store)));
    paintOther(this.write, this.other, this.store, this.#knob, now);
  }
}
