/** The panel of a pose: every joint by a slider, in degrees as anatomy counts them. */

import { html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { base } from "../../ui/theme";
import { amountOf } from "../controls/amount";
import { controls, panel } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import { PERCENT, type Unit } from "../controls/units";
import { alike, mirrored, readWord, WORDS, type Word, writeWord } from "../pose/pose_words";
import type { Topic } from "../session/draft_store";
import "../controls/amount";

const UNITS: Readonly<Record<Word["unit"], Unit>> = {
  degrees: { name: "°", per: 1, decimals: 0 },
  legs: { name: "leg", per: 1, decimals: 2 },
  share: PERCENT,
};

/** How a pose is made: sides alike, the mirror image, and a slider for each joint. */
@customElement("omote-pose-words")
export class PosePanel extends EditorElement {
  static override styles = [base, controls, panel];

  protected override readonly topics: readonly Topic[] = ["draft", "live", "options"];

  override render() {
    const { store } = this;
    const recipe = store.livePose ?? store.pose;
    if (recipe === null) return nothing;
    return html`
      <p>Left and right are the character's own. The same pose is done by every body.</p>
      <label class="row"><input type="checkbox" .checked=${store.options.mirror}
        @change=${() => store.setOptions({ mirror: !store.options.mirror })} /> Both sides alike (X)</label>
      <button @click=${() => store.setPose(mirrored(recipe), "mirror image")}>Mirror image</button>
      ${WORDS.map(([title, words]) => html`<h2>${title}</h2>${words.map((word) => this.#slider(title, word, readWord(recipe, word)))}`)}
    `;
  }

  #slider(title: string, word: Word, value: number) {
    return html`<omote-amount data-word=${word.path.join(".")} label=${word.label} hint="${title}: ${word.label}" .unit=${UNITS[word.unit]}
      .low=${word.low} .high=${word.high} .value=${value}
      @live=${(event: Event) => this.store.showPose(this.#changed(word, amountOf(event)))}
      @done=${(event: Event) => this.store.setPose(this.#changed(word, amountOf(event)), `${title}, ${word.label}`.toLowerCase())}></omote-amount>`;
  }

  #changed(word: Word, value: number) {
    const { store } = this;
    const recipe = writeWord((store.livePose ?? store.pose) as NonNullable<typeof store.pose>, word, value);
    return store.options.mirror ? alike(recipe, word.path[0]) : recipe;
  }
}
