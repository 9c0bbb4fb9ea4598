/** How much the character moves by itself: lids, eyes and the head that follows them, breath; what swings of it; and what its skin shows. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { SKIN_FADERS, SKIN_LIMIT, SPRINGS } from "../../link/constants";
import { base } from "../../ui/theme";
import { type Knob, type MotionDetail, type SkinFader, type SpringName, STILL } from "../store/knob";
import type { Topic } from "../store/page_store";
import { GazeTargetCommands } from "./gaze_target_commands";
import { SliderSettings, sliderStyle } from "./slider_settings";

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

const style = css`
  .idle {
    grid-column: 1 / -1;
    min-height: 30px;
  }
  @media (pointer: coarse) {
    .idle {
      min-height: var(--finger);
    }
  }
`;

@customElement("omote-motion-settings")
export class MotionSettings extends SliderSettings<MotionDetail | SpringName> {
  static override styles = [base, ...sliderStyle, style];

  protected override readonly topics: readonly Topic[] = ["manifest"];

  override render() {
    const springs = SPRINGS.filter((spring) => this.store.expressions.some(({ name }) => name === spring));
    return html`${SLIDERS.map(([name, label, most, title]) => this.slider({ name, label, title, most, rest: STILL[name] }))}
      <button class="idle" aria-pressed="false" @click=${this.#idle}
        title="Where it holds still otherwise, it moves as people do until its tracker is back">Idles when its tracker is lost</button>
      ${springs.map((name) => this.slider({ name, label: SPRING_WORDS[name][0], title: SPRING_WORDS[name][1], most: MOST_SPRING, rest: 1 }))}`;
  }

  protected knob(name: MotionDetail | SpringName): Knob {
    return name in SPRING_WORDS ? this.store.spring(name as SpringName) : this.store.motion(name as MotionDetail);
  }

  readonly #idle = (): void => {
    new GazeTargetCommands(this.store).idle(!(this.store.air?.motion?.idle ?? false));
  };

  override paint(now: number): void {
    super.paint(now);
    const { air } = this.store;
    if (air === null || this.offsetParent === null) return;
    const idle = this.renderRoot.querySelector(".idle") as HTMLElement;
    this.write.attribute(idle, "aria-pressed", String(air.motion?.idle ?? false));
  }
}

/** What each fader of the skin is for. */
const SKIN_WORDS: Readonly<Record<SkinFader, readonly [label: string, title: string]>> = {
  folds: ["Folds", "How deep skin folds where expressions press it together; deeper with age"],
  blood: ["Blush and pallor", "How much the skin reddens and pales with expressions; it follows in seconds"],
};

/** How much of what expressions do to the skin shows. */
@customElement("omote-skin-settings")
export class SkinSettings extends SliderSettings<SkinFader> {
  static override styles = [base, ...sliderStyle];

  override render() {
    return html`${SKIN_FADERS.map((name) => this.slider({ name, label: SKIN_WORDS[name][0], title: SKIN_WORDS[name][1], most: SKIN_LIMIT, rest: 1 }))}`;
  }

  protected knob(name: SkinFader): Knob {
    return this.store.skin(name);
  }
}
