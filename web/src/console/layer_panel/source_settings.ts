/** What feeds a layer: whom it drives, in which parts, how calmly, and how it is read. Tells `calibrate`. */

import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import { ALL, DRIVEN_LAYERS, LAYER_PARTS } from "../../link/constants";
import type { SourceState } from "../../link/messages";
import { base } from "../../ui/theme";
import { ConsoleElement, chosenIn } from "../controls/console_element";
import { livelinessOf, secondsOf, smoothingWords } from "../sources/calm_scale";
import type { Topic } from "../store/page_store";
import { LayerCommands, layerLabel, type Tuning, withCharacter, withPart } from "./layer_commands";

/** A number of a source: its range, and what it does. */
const NUMBERS = [
  ["gain", "Gain", 0, 4, 0.05, "Of all channels"],
  ["lids", "Lids", 0, 4, 0.05, "Gain of those that shut the eyes: more, where yours do not quite close"],
  ["curve", "Curve", -1, 1, 0.05, "Above 0 small moves grow, below they shrink"],
  ["dead_zone", "Dead zone", 0, 0.5, 0.01, "Less is nothing: holds a trembling face still"],
] as const satisfies readonly (readonly [keyof Tuning, string, number, number, number, string])[];

@customElement("omote-source-settings")
export class SourceSettings extends ConsoleElement {
  @property({ attribute: false }) source!: SourceState;

  static override styles = [
    base,
    css`
      :host {
        display: grid;
        gap: 6px;
        padding: 6px 8px;
        border: 1px solid var(--line);
        border-radius: 6px;
        background: var(--raised);
      }
      .row {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: 4px 6px;
      }
      b {
        overflow-wrap: anywhere;
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
      label.calm {
        grid-template-columns: auto minmax(0, 1fr) auto 42px;
      }
      label output {
        text-align: right;
      }
      details label {
        margin-top: 6px;
      }
      summary {
        color: var(--dim);
        cursor: pointer;
      }
      .row button {
        min-height: 30px;
        padding: 0 7px;
      }
      input[type="range"] {
        width: 100%;
        margin: 0;
        accent-color: var(--hand);
      }
      @media (pointer: coarse) {
        input[type="range"] {
          height: var(--finger);
        }
        .row button,
        summary {
          min-height: var(--finger);
        }
      }
    `,
  ];

  protected override topics(): readonly Topic[] {
    return ["characters"];
  }

  get #commands(): LayerCommands {
    return new LayerCommands(this.store);
  }

  override render() {
    const { source } = this;
    const from = source.console === "" ? "" : ` at ${source.console}`;
    return html`<div class="row"><b>${source.name}</b>
        <span class="dim">${source.kind}${from}, ${source.found ? `${source.rate}/s` : "sees nobody"}</span></div>
      ${this.#route()} ${this.#parts()} ${this.#smoothing()} ${this.#buttons()}
      <details><summary>Gain, lids, curve, layer</summary>
        ${this.#layer()} ${NUMBERS.map((number) => this.#number(number))}</details>`;
  }

  #route() {
    const { source } = this;
    const characters = Object.entries(this.store.state?.characters ?? {});
    const names = characters.map(([name]) => name);
    return html`<div class="row" role="group" aria-label="Whom ${source.name} drives"><span class="dim">plays</span>
      ${characters.map(
        ([
          name,
          { label },
        ]) => html`<button data-drives=${name} aria-pressed=${source.characters.includes(ALL) || source.characters.includes(name)}
          @click=${() => this.#commands.route(source, { characters: withCharacter(source.characters, name, names) })}>${label}</button>`,
      )}
    </div>`;
  }

  #parts() {
    const { source } = this;
    return html`<div class="row" role="group" aria-label="Parts that ${source.name} plays"><span class="dim">in</span>
      ${LAYER_PARTS.map(
        (part) => html`<button data-part=${part} aria-pressed=${source.regions.includes(part)}
          title="Of two sources of a layer the one with fewer parts has them"
          @click=${() => this.#commands.route(source, { regions: withPart(source.regions, part) })}>${part}</button>`,
      )}
    </div>`;
  }

  #smoothing() {
    const { smoothing } = this.source;
    const set = (seconds: number): void => this.#commands.tune(this.source, { smoothing: seconds });
    return html`<label class="calm" title="Calm: slow and still. Lively: every twitch. Double click: as usual">
      <span class="dim">calm</span><input type="range" name="smoothing" aria-label="Smoothing of ${this.source.name}, calm to lively"
        aria-valuetext=${smoothingWords(smoothing)} min="0" max="1" step="0.01" .value=${String(livelinessOf(smoothing))}
        @dblclick=${() => set(secondsOf(null))}
        @change=${(event: Event) => set(secondsOf(Number((event.target as HTMLInputElement).value)))} />
      <span class="dim">lively</span><output>${smoothingWords(smoothing)}</output></label>`;
  }

  #buttons() {
    const { source } = this;
    return html`<div class="row">
      <button class="calibrate" title="Face at rest, and the largest of each move: seen as bars" @click=${this.#calibrate}>${source.calibrated ? "Calibrated…" : "Calibrate…"}</button>
      <button data-mirror aria-pressed=${source.mirror} title="Left and right are swapped"
        @click=${() => this.#commands.tune(source, { mirror: !source.mirror })}>Mirror</button>
    </div>`;
  }

  readonly #calibrate = (): void => {
    const detail = this.source.name;
    this.dispatchEvent(new CustomEvent("calibrate", { detail, bubbles: true, composed: true }));
  };

  #layer() {
    const { source } = this;
    return html`<label>Layer<select aria-label="Layer of ${source.name}" @change=${(event: Event) => this.#relayer(chosenIn(event))}>
        ${DRIVEN_LAYERS.map((layer) => html`<option value=${layer} .selected=${layer === source.layer}>${layerLabel(layer)}</option>`)}
      </select></label>`;
  }

  #relayer(chosen: string): void {
    const layer = DRIVEN_LAYERS.find((one) => one === chosen);
    if (layer !== undefined) this.#commands.route(this.source, { layer });
  }

  #number([name, label, low, high, step, title]: (typeof NUMBERS)[number]) {
    const value = this.source[name];
    return html`<label title=${title}>${label}<input type="range" name=${name} min=${low} max=${high} step=${step} .value=${String(value)}
      @change=${(event: Event) => this.#commands.tune(this.source, { [name]: Number((event.target as HTMLInputElement).value) })}
      /><output>${value.toFixed(2)}</output></label>`;
  }
}
