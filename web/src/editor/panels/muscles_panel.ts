/** The panel of muscle contractions. */

import { html } from "lit";
import { customElement } from "lit/decorators.js";
import { base } from "../../ui/theme";
import { amountOf } from "../controls/amount";
import { controls, panel } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import { PERCENT } from "../controls/units";
import { mirrorMuscle } from "../session/control_net";
import type { Topic } from "../session/draft_store";

/** Muscles by their contraction; every face follows while a slider moves. */
@customElement("omote-muscles")
export class MusclesPanel extends EditorElement {
  static override styles = [base, controls, panel];

  protected override readonly topics: readonly Topic[] = ["draft", "live", "options", "items"];

  override render() {
    const { store } = this;
    return html`
      <p>Muscles of the face, defined once, at work on every face. Left is the character's own left, on the right of the picture${store.options.mirror ? "; Mirror is on: both sides move" : ""}.</p>
      <label class="row"><input type="checkbox" .checked=${store.options.muscles}
        @change=${() => store.setOptions({ muscles: !store.options.muscles })} /> Show them on the face (U)</label>
      ${store.muscles.map(
        ({ name, label, kind }) => html`<omote-amount data-muscle=${name} label=${label} hint="${label} (${kind})"
          .unit=${PERCENT} .value=${store.livePulls.get(name) ?? 0}
          @live=${(event: Event) => this.#pull(name, amountOf(event))}
          @done=${(event: Event) => {
            this.#pull(name, Math.min(1, Math.max(0, amountOf(event))));
            store.sendPulls();
          }}></omote-amount>`,
      )}
      <button ?disabled=${![...store.livePulls.values()].some((pull) => pull !== 0)} @click=${this.#relax}>All at rest</button>
    `;
  }

  /** With Mirror on its twin on the other side goes along. */
  #pull(name: string, contraction: number): void {
    const twin = mirrorMuscle(name);
    this.store.pull(name, contraction);
    if (this.store.options.mirror && this.store.muscles.some((muscle) => muscle.name === twin))
      this.store.pull(twin, contraction);
  }

  readonly #relax = (): void => {
    for (const name of this.store.livePulls.keys()) this.store.pull(name, 0);
    this.store.sendPulls();
  };
}
