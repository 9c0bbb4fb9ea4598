/** A source: how it stands, and unfolded whom it drives, in which parts, how it is read. Tells `calibrate`, `fold`. */

import { css, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import { ALL, DRIVEN_LAYERS, ROUTE_PARTS } from "../../link/constants";
import type { SourceState } from "../../link/messages";
import { base, ellipsis, flow } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { ConsoleElement } from "../controls/console_element";
import type { Topic } from "../store/page_store";
import { sourceAddress, sourceLabel } from "../store/source_label";
import "./source_tuning";
import { LayerCommands, layerLabel, withCharacter, withPart } from "./layer_commands";

const style = css`
  :host {
    display: grid;
    gap: 6px;
    padding: 4px 6px;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--raised);
  }
  .row {
    ${flow}
    gap: 4px 6px;
  }
  .head {
    display: flex;
    gap: 4px;
  }
  .name {
    flex: 1;
    display: grid;
    gap: 0;
    min-width: 0;
    padding: 2px 6px;
    text-align: left;
    color: var(--text);
    background: none;
    border-color: transparent;
  }
  .name[aria-expanded="false"]::after {
    content: "▸";
    grid-area: 1 / 2 / 3;
    align-self: center;
    justify-self: end;
  }
  .name b,
  .name span {
    ${ellipsis}
  }
  .wanted {
    font-size: 12px;
    color: var(--attention);
  }
  .calibrate {
    flex: none;
  }
  .parts {
    display: grid;
    grid-template-columns: 0.7fr repeat(6, minmax(0, 1fr));
    align-items: center;
    gap: 3px;
  }
  .parts button {
    min-width: 0;
    padding: 0;
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
  .row button,
  .parts button {
    min-height: 30px;
  }
  .row button {
    padding: 0 7px;
  }
  /* as wide as a tablet held upright, and as low as its mixer: whom it plays beside how calmly */
  @media (min-width: 600px) and (max-width: 999px) {
    :host([open]) {
      grid-template-columns: auto minmax(0, 1fr);
    }
    .head,
    .parts,
    details {
      grid-column: 1 / -1;
    }
  }
  @media (pointer: coarse) {
    .row button,
    .parts button,
    summary {
      min-height: var(--finger);
    }
  }
`;

@customElement("omote-source-settings")
export class SourceSettings extends ConsoleElement {
  @property({ attribute: false }) source!: SourceState;
  @property({ type: Boolean }) open = false;

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["characters"];

  get #commands(): LayerCommands {
    return new LayerCommands(this.store);
  }

  override render() {
    const { open } = this;
    return html`<div class="head"><button class="name" aria-expanded=${open} title=${this.#title()} @click=${this.#fold}>
          <b>${this.#label}</b><span class=${this.#state() === "" ? "dim" : "wanted"}>${this.#state() || this.#plays()}</span></button>
        ${open ? this.#calibration() : nothing}</div>
      ${open ? this.#settings() : nothing}`;
  }

  #settings() {
    const { source } = this;
    return html`${this.#route()}
      <omote-source-tuning .context=${this.context} .source=${source}></omote-source-tuning>
      ${this.#parts()}
      <details><summary>Mirror, gain, lids, curve, layer</summary>
        <div class="row"><button data-mirror aria-pressed=${source.mirror} title="Left and right are swapped"
          @click=${() => this.#commands.tune(source, { mirror: !source.mirror })}>Mirror</button></div>
        ${this.#layer()} <omote-source-tuning .context=${this.context} .source=${source} numbers></omote-source-tuning></details>`;
  }

  get #label(): string {
    return sourceLabel(
      this.source.name,
      this.store.sources.map(({ name }) => name),
    );
  }

  /** Where it is, and how often it is heard. */
  #title(): string {
    const { name, kind, console: page, rate } = this.source;
    return [kind, sourceAddress(name), page === "" ? "" : `at ${page}`, `${rate}/s`].filter(Boolean).join(", ");
  }

  /** What is wrong with it, "" for nothing. */
  #state(): string {
    const { rate, found, characters } = this.source;
    if (rate === 0) return "sends nothing";
    if (!found) return "sees nobody";
    return characters.length === 0 ? "plays nobody" : "";
  }

  #plays(): string {
    const { characters, layer, rate, body } = this.source;
    const labels = characters.map((name) =>
      name === ALL ? "all" : (this.store.state?.characters[name]?.label ?? name),
    );
    return `${labels.join(", ")} · ${layer}${body ? " and body" : ""} · ${rate}/s`;
  }

  readonly #fold = (): void => {
    this.tell("fold");
  };

  #route() {
    const { source } = this;
    const characters = Object.entries(this.store.state?.characters ?? {});
    const names = characters.map(([name]) => name);
    return html`<div class="row" role="group" aria-label="Whom ${source.name} drives"><span class="dim">plays</span>
      ${characters.map(
        ([name, { label }]) => html`<button data-drives=${name}
          aria-pressed=${source.characters.includes(ALL) || source.characters.includes(name)}
          @click=${() => this.#commands.route(source, { characters: withCharacter(source.characters, name, names) })}>${label}</button>`,
      )}
    </div>`;
  }

  #parts() {
    const { source } = this;
    const idle = source.characters.length === 0;
    return html`<div class="parts" role="group" aria-label="Parts that ${source.name} plays"><button class="all" aria-pressed=${!idle && ROUTE_PARTS.every((part) => source.regions.includes(part))}
        ?disabled=${idle} title="All parts" @click=${() => this.#commands.route(source, { regions: [...ROUTE_PARTS] })}>all</button>
      ${ROUTE_PARTS.map(
        (
          part,
        ) => html`<button data-part=${part} ?disabled=${idle} aria-pressed=${!idle && source.regions.includes(part)}
          title=${idle ? "Press first whom it plays" : "Of all parts this one alone; then others to it. Of two sources the one with fewer parts has them"}
          @click=${() => this.#commands.route(source, { regions: withPart(source.regions, part) })}>${part}</button>`,
      )}
    </div>`;
  }

  #calibration() {
    const words = this.source.calibrated ? "Calibrated…" : "Calibrate…";
    return html`<button class="calibrate" title="Face at rest, and the largest of each move: seen as bars" @click=${this.#calibrate}>${words}</button>`;
  }

  readonly #calibrate = (): void => {
    const detail = this.source.name;
    this.dispatchEvent(new CustomEvent("calibrate", { detail, bubbles: true, composed: true }));
  };

  #layer() {
    const { source } = this;
    return html`<label>Layer<select aria-label="Layer of ${source.name}" @change=${(event: Event) => this.#relayer(textOf(event))}>
        ${DRIVEN_LAYERS.map((layer) => html`<option value=${layer} .selected=${layer === source.layer}>${layerLabel(layer)}</option>`)}
      </select></label>`;
  }

  #relayer(chosen: string): void {
    const layer = DRIVEN_LAYERS.find((driven) => driven === chosen);
    if (layer !== undefined) this.#commands.route(this.source, { layer });
  }
}
