/** The panel that sets blood, tears and sweat of an expression. */

import { html } from "lit";
import { customElement } from "lit/decorators.js";
import { COMPLEXION, COMPLEXION_RANGES } from "../../link/constants";
import type { Recipe } from "../../link/editing_messages";
import { base } from "../../ui/theme";
import { amountOf } from "../controls/amount";
import { controls, panel } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import { PERCENT } from "../controls/units";
import type { Topic } from "../session/draft_store";

type Part = keyof typeof COMPLEXION;

const PARTS = Object.keys(COMPLEXION) as Part[];
const LABELS: Readonly<Record<Part, string>> = {
  cheeks: "Cheeks",
  nose: "Nose and chin",
  forehead: "Forehead",
  eyes: "Around the eyes",
  whole: "The whole face",
  tears: "Tears",
  sweat: "Sweat",
};

/** Blood, tears and sweat: what the expression adds to those of its layers. */
@customElement("omote-complexion")
export class ComplexionPanel extends EditorElement {
  static override styles = [base, controls, panel];

  protected override readonly topics: readonly Topic[] = ["draft", "live"];

  override render() {
    return html`
      <p>What this expression adds to the blood in the skin: 100 % is a strong flush, below 0 the skin pales. On air it follows
        in seconds, sweat in half a minute. Tears and beads of sweat run from 50 % on.</p>
      ${PARTS.map((part, at) => this.#slider(part, at))}
      <button ?disabled=${this.store.liveComplexion.every((value) => value === 0)} @click=${() => this.#send([0, 0, 0, 0, 0, 0, 0])}>As at rest</button>
    `;
  }

  #slider(part: Part, at: number) {
    const { liveComplexion } = this.store;
    const changed = (event: Event): Recipe["complexion"] =>
      liveComplexion.map((value, other) => (other === at ? amountOf(event) : value)) as Recipe["complexion"];
    return html`<omote-amount label=${LABELS[part]} .unit=${PERCENT} .low=${-1} .high=${COMPLEXION_RANGES[part][1]}
      .value=${liveComplexion[at]} @live=${(event: Event) => this.store.flush(changed(event))}
      @done=${(event: Event) => this.#send(changed(event))}></omote-amount>`;
  }

  #send(complexion: Recipe["complexion"]): void {
    this.store.flush(complexion);
    this.store.sendComplexion();
  }
}
