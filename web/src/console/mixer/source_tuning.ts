/** How a source is read: from calm to lively, or its gain, lids, curve and dead zone. */

import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { SourceState } from "../../link/messages";
import { base } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { ConsoleElement } from "../controls/console_element";
import { livelinessOf, secondsOf, smoothingWords } from "./calm_scale";
import { LayerCommands, type Tuning } from "./layer_commands";

/** A number of a source: its range, and what it does. */
const NUMBERS = [
  ["gain", "Gain", 0, 4, 0.05, "Of all channels"],
  ["lids", "Lids", 0, 4, 0.05, "Gain of those that shut the eyes: more, where yours do not quite close"],
  ["curve", "Curve", -1, 1, 0.05, "Above 0 small moves grow, below they shrink"],
  ["dead_zone", "Dead zone", 0, 0.5, 0.01, "Less is nothing: holds a trembling face still"],
] as const satisfies readonly (readonly [keyof Tuning, string, number, number, number, string])[];

const style = css`
  :host {
    display: grid;
    gap: 6px;
  }
  .dim {
    font-size: 12px;
    color: var(--dim);
  }
  label {
    display: grid;
    grid-template-columns: 74px minmax(0, 1fr) 34px;
    align-items: center;
    gap: 6px;
  }
  .smoothing {
    display: grid;
    grid-template-columns: minmax(0, 1fr) 62px;
    align-items: center;
    gap: 6px;
  }
  label.calm {
    grid-template-columns: auto minmax(0, 1fr) auto;
  }
  .usual {
    min-height: 30px;
    padding: 0 4px;
  }
  output {
    text-align: right;
  }
  input[type="range"] {
    width: 100%;
  }
  @media (pointer: coarse) {
    input[type="range"],
    .usual {
      height: var(--finger);
    }
  }
`;

@customElement("omote-source-tuning")
export class SourceTuning extends ConsoleElement {
  @property({ attribute: false }) source!: SourceState;
  /** Gain, lids, curve and dead zone in the place of calm to lively. */
  @property({ type: Boolean }) numbers = false;

  static override styles = [base, style];

  get #commands(): LayerCommands {
    return new LayerCommands(this.store);
  }

  override render() {
    return this.numbers
      ? NUMBERS.map((number) => this.#number(number))
      : html`<div class="smoothing">${this.#smoothing()}</div>`;
  }

  #smoothing() {
    const { smoothing } = this.source;
    const set = (seconds: number): void => this.#commands.tune(this.source, { smoothing: seconds });
    return html`<label class="calm" title="Calm: slow and still. Lively: every twitch">
      <span class="dim">calm</span><input type="range" name="smoothing" aria-label="Smoothing of ${this.source.name}, calm to lively"
        aria-valuetext=${smoothingWords(smoothing)} min="0" max="1" step="0.01" .value=${String(livelinessOf(smoothing))}
        @change=${(event: Event) => set(secondsOf(Number(textOf(event))))} />
      <span class="dim">lively</span></label>
      <button class="usual" aria-pressed=${smoothing === 0} title="As its layer is: speech arrives, trembling does not"
        @click=${() => set(secondsOf(null))}>${smoothingWords(smoothing)}</button>`;
  }

  #number([name, label, low, high, step, title]: (typeof NUMBERS)[number]) {
    const value = this.source[name];
    return html`<label title=${title}>${label}<input type="range" name=${name} min=${low} max=${high} step=${step} .value=${String(value)}
      @change=${(event: Event) => this.#commands.tune(this.source, { [name]: Number(textOf(event)) })}
      /><output>${value.toFixed(2)}</output></label>`;
  }
}
