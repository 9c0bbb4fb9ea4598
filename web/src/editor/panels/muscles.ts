import { html } from "lit";
import { customElement } from "lit/decorators.js";
import { base } from "../../console/theme";
import { amountOf } from "../amount";
import { controls, panel } from "../controls_style";
import { BenchElement } from "../element";
import { PERCENT } from "../units";
import type { Topic } from "../workbench";

/** Muscles by their contraction; every face follows while a slider moves. */
@customElement("omote-muscles")
export class Muscles extends BenchElement {
  static override styles = [base, controls, panel];

  protected override topics(): readonly Topic[] {
    return ["draft", "live", "options", "items"];
  }

  override render() {
    const { bench } = this;
    return html`
      <p>Muscles of the face, defined once, at work on every face.</p>
      <label class="row"><input type="checkbox" .checked=${bench.options.muscles}
        @change=${() => bench.setOptions({ muscles: !bench.options.muscles })} /> Show them on the face (U)</label>
      ${bench.muscles.map(
        ({
          name,
          label,
          kind,
        }) => html`<omote-amount data-muscle=${name} label=${label} hint="${label} (${kind})" .unit=${PERCENT}
          .value=${bench.livePulls.get(name) ?? 0}
          @live=${(event: Event) => bench.pull(name, amountOf(event))}
          @done=${(event: Event) => {
            bench.pull(name, Math.min(1, Math.max(0, amountOf(event))));
            bench.sendPulls();
          }}></omote-amount>`,
      )}
      <button ?disabled=${![...bench.livePulls.values()].some((pull) => pull !== 0)} @click=${this.#relax}>All at rest</button>
    `;
  }

  readonly #relax = (): void => {
    for (const name of this.bench.livePulls.keys()) this.bench.pull(name, 0);
    this.bench.sendPulls();
  };
}
