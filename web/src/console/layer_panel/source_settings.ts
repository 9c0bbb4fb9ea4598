/** What feeds a layer, and how it is read: whom it drives, on which layer, mirror, gain, curve, dead zone, smoothing, the performer at rest. */

import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import { ALL, DRIVEN_LAYERS } from "../../link/constants";
import type { SourceState } from "../../link/messages";
import { base } from "../../ui/theme";
import { ConsoleElement, chosenIn } from "../controls/console_element";
import type { Topic } from "../store/page_store";
import { LayerCommands, layerLabel, type Tuning, withCharacter } from "./layer_commands";

/** A number of a source: its range, and what it does. */
const NUMBERS = [
  ["gain", "Gain", 0, 4, 0.05, "Of all channels"],
  ["curve", "Curve", -1, 1, 0.05, "Above 0 small moves grow, below they shrink"],
  ["dead_zone", "Dead zone", 0, 0.5, 0.01, "Less is nothing: holds a trembling face still"],
  ["smoothing", "Smoothing", 0, 2, 0.05, "Seconds in which a step is followed, beyond what all sources are smoothed"],
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
      label output {
        text-align: right;
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
      ${this.#route()} ${NUMBERS.map((number) => this.#number(number))} ${this.#measure()}`;
  }

  #route() {
    const { source } = this;
    const characters = Object.entries(this.store.state?.characters ?? {});
    const names = characters.map(([name]) => name);
    return html`<div class="row" role="group" aria-label="Whom ${source.name} drives">
      ${characters.map(
        ([
          name,
          { label },
        ]) => html`<button data-drives=${name} aria-pressed=${source.characters.includes(ALL) || source.characters.includes(name)}
          @click=${() => this.#commands.route(source, { characters: withCharacter(source.characters, name, names) })}>${label}</button>`,
      )}
      <select aria-label="Layer of ${source.name}" @change=${(event: Event) => this.#relayer(chosenIn(event))}>
        ${DRIVEN_LAYERS.map((layer) => html`<option value=${layer} .selected=${layer === source.layer}>${layerLabel(layer)}</option>`)}
      </select>
      <button data-mirror aria-pressed=${source.mirror} title="Left and right are swapped"
        @click=${() => this.#commands.tune(source, { mirror: !source.mirror })}>Mirror</button>
    </div>`;
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

  #measure() {
    const { calibrated, ranging } = this.source;
    const step = (at: "neutral" | "range" | "done" | "reset") => () => this.#commands.calibrate(this.source, at);
    return html`<div class="row" role="group" aria-label="Measure of ${this.source.performer}">
      <button data-step="neutral" title="Hold the face still and at rest, then press" @click=${step("neutral")}>At rest now</button>
      <button data-step=${ranging ? "done" : "range"} aria-pressed=${ranging} title="Press, make the largest faces, press again"
        @click=${step(ranging ? "done" : "range")}>${ranging ? "Done" : "Largest faces"}</button>
      <button data-step="reset" ?disabled=${!calibrated} title="It is read as it sends" @click=${step("reset")}>Forget</button>
    </div>`;
  }
}
