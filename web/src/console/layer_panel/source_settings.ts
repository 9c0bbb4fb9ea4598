/** What feeds a layer: whom it drives, in which parts, how calmly, and how it is read. Tells `calibrate`. */

import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import { ALL, DRIVEN_LAYERS, LAYER_PARTS } from "../../link/constants";
import type { SourceState } from "../../link/messages";
import { base } from "../../ui/theme";
import { ConsoleElement, chosenIn } from "../controls/console_element";
import type { Topic } from "../store/page_store";
import "./source_tuning";
import { LayerCommands, layerLabel, withCharacter, withPart } from "./layer_commands";

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
        grid-template-columns: 74px minmax(0, 1fr);
        align-items: center;
        gap: 6px;
      }
      details > * + * {
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
      @media (pointer: coarse) {
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
      ${this.#route()} ${this.#parts()}
      <omote-source-tuning .context=${this.context} .source=${source}></omote-source-tuning> ${this.#buttons()}
      <details><summary>Gain, lids, curve, layer</summary>
        ${this.#layer()} <omote-source-tuning .context=${this.context} .source=${source} numbers></omote-source-tuning></details>`;
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
    const idle = source.characters.length === 0;
    return html`<div class="row" role="group" aria-label="Parts that ${source.name} plays"><span class="dim">in</span>
      ${LAYER_PARTS.map(
        (
          part,
        ) => html`<button data-part=${part} aria-pressed=${!idle && source.regions.includes(part)} ?disabled=${idle}
          title=${idle ? "Press first whom it plays" : "Of two sources of a layer the one with fewer parts has them"}
          @click=${() => this.#commands.route(source, { regions: withPart(source.regions, part) })}>${part}</button>`,
      )}
    </div>`;
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
}
