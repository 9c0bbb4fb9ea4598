/** How much of what expressions do to the skin shows. */

import { html } from "lit";
import { customElement } from "lit/decorators.js";
import { SKIN_FADERS, SKIN_LIMIT } from "../../link/constants";
import { base } from "../../ui/theme";
import type { Knob, SkinFader } from "../store/knob";
import { SliderSettings, sliderStyle } from "./slider_settings";

/** What each fader of the skin is for. */
const WORDS: Readonly<Record<SkinFader, readonly [label: string, title: string]>> = {
  folds: ["Folds", "How deep skin folds where expressions press it together; deeper with age"],
  blood: ["Blush and pallor", "How much the skin reddens and pales with expressions; it follows in seconds"],
};

@customElement("omote-skin-settings")
export class SkinSettings extends SliderSettings<SkinFader> {
  static override styles = [base, ...sliderStyle];

  override render() {
    return html`${SKIN_FADERS.map((name) => this.slider({ name, label: WORDS[name][0], title: WORDS[name][1], most: SKIN_LIMIT, rest: 1 }))}`;
  }

  protected knob(name: SkinFader): Knob {
    return this.store.skin(name);
  }
}
