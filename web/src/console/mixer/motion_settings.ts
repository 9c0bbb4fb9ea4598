/** How much the character moves by itself: lids, eyes and the head that follows them, breath; what swings of it, and what its skin shows. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { SKIN_FADERS, SKIN_LIMIT, SPRINGS } from "../../link/constants";
import { base } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { AnimatedElement } from "../controls/console_element";
import { otherStyle, paintOther } from "../controls/other_hand";
import { type Knob, type MotionDetail, type SkinFader, type SpringName, STILL } from "../store/knob";
import type { Topic } from "../store/page_store";
import { GazeTargetCommands } from "./gaze_target_commands";

/** What each slider sets: its label, where it ends, and in words. */
const SLIDERS: readonly (readonly [MotionDetail, string, number, string])[] = [
  ["liveliness", "Liveliness", 1, "0 holds it still, 50 is as people move; drives the layers blink, gaze and breath"],
  ["blinks", "Blink rate", 2, "How often lids close beside that; 100 as people's do"],
  ["gaze", "Eye travel", 2, "How far the eyes wander, and the head with them"],
  ["breath", "Breath depth", 2, "How deep it breathes, and how much it trembles"],
];

/** What each spring swings, in words: of a face that has such, and as much as it is lively. */
const SPRING_WORDS: Readonly<Record<SpringName, readonly [label: string, title: string]>> = {
  "ears-sway": ["Ears sway", "How far ears swing aside as the head turns and tilts; cats and dogs have such"],
  "ears-flap": ["Ears flap", "How far ears swing up and down as the head nods; cats and dogs have such"],
  "jowls-sway": ["Jowls sway", "How far the jowls of heavy faces swing as the head turns and tilts"],
  "cheeks-bounce": ["Cheeks bounce", "How far cheeks bounce as the head nods and the jaw opens"],
};
const MOST_SPRING = 2;

/** What each fader of the skin is for. */
const SKIN_WORDS: Readonly<Record<SkinFader, readonly [label: string, title: string]>> = {
  folds: ["Folds", "How deep skin folds where expressions press it together; deeper with age"],
  blood: ["Blush and pallor", "How much the skin reddens and pales with expressions; it follows in seconds"],
};

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
    min-height: 21px;
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

  protected override readonly topics: readonly Topic[] = ["manifest"];

  override render() {
    const springs = SPRINGS.filter((spring) => this.store.expressions.some(({ name }) => name === spring));
    return html`${SLIDERS.map(([detail, label, most, title]) => this.#slider(detail, label, most, title))}
      <button class="idle" aria-pressed="false" @click=${this.#idle}
        title="Where it holds still otherwise, it moves as people do until its tracker is back">Idles when its tracker is lost</button>
      ${springs.map((spring) => this.#slider(spring, SPRING_WORDS[spring][0], MOST_SPRING, SPRING_WORDS[spring][1]))}
      ${SKIN_FADERS.map((fader) => this.#slider(fader, SKIN_WORDS[fader][0], SKIN_LIMIT, SKIN_WORDS[fader][1]))}`;
  }

  #slider(name: Setting, label: string, most: number, title: string) {
    const knob = (): Knob => this.#knob(name);
    const rest = isSpring(name) || isOfSkin(name) ? 1 : STILL[name];
    return html`<label title=${title}><span>${label}</span>
      <span class="way"><input type="range" name=${name} min="0" max=${most} step="0.05"
        @input=${(event: Event) => knob().grip(Number(textOf(event)))} @change=${() => knob().leave()}
        @dblclick=${() => knob().nudge(rest)} /><span class="other"></span></span>
      <span class="number"></span></label>`;
  }

  #knob(name: Setting): Knob {
    if (isOfSkin(name)) return this.store.skin(name);
    return isSpring(name) ? this.store.spring(name) : this.store.motion(name);
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
    const knob = this.#knob(input.name as Setting);
    const value = knob.value(now);
    if (!knob.gripped() && Number(input.value) !== value) input.value = String(value);
    const [way, write] = [input.parentElement as HTMLElement, this.write];
    write.text(way.nextElementSibling as HTMLElement, String(Math.round(100 * value)));
    write.attribute(input, "aria-valuetext", `${Math.round(100 * value)} percent`);
    paintOther(write, way.querySelector(".other") as HTMLElement, this.store, knob, now);
  }
}

type Setting = MotionDetail | SpringName | SkinFader;

const isOfSkin = (name: Setting): name is SkinFader => name in SKIN_WORDS;
const isSpring = (name: Setting): name is SpringName => name in SPRING_WORDS;
