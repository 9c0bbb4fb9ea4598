/** The panel of the expressions that lie under the control points. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { live } from "lit/directives/live.js";
import { repeat } from "lit/directives/repeat.js";
import type { Layer } from "../../link/editing_messages";
import { base } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { amountOf } from "../controls/amount";
import { controls, panel } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import { sourceChoice } from "../controls/source_choice";
import { PERCENT } from "../controls/units";
import type { Topic } from "../session/draft_store";
import { bake } from "../session/item_commands";
import { labelOf, sourcesOf } from "../session/sources";

const style = css`
  .name {
    font-weight: 600;
  }
  .silent .name {
    color: var(--faint);
    text-decoration: line-through;
  }
  .switch {
    font-weight: 700;
  }
  .switch[aria-pressed="true"] {
    color: var(--ground);
    background: var(--text);
    border-color: var(--text);
  }
  .mute[aria-pressed="true"] {
    background: var(--attention);
    border-color: var(--attention);
  }
`;

/** Expressions laid under the control points: brow of one, mouth of another. */
@customElement("omote-layers")
export class LayersPanel extends EditorElement {
  static override styles = [base, controls, panel, style];

  protected override readonly topics: readonly Topic[] = ["draft", "items", "cast"];

  get #layers(): readonly Layer[] {
    return this.store.recipe?.layers ?? [];
  }

  #change(at: number, change: Partial<Layer>): void {
    this.store.setLayers((layers) => changed(layers, at, change));
  }

  /** Shows what a change of a layer would make, without making it. */
  #try(at: number, change: Partial<Layer>): void {
    this.store.layerPreview.show(changed(this.#layers, at, change));
  }

  #move(at: number, by: -1 | 1): void {
    this.store.layerPreview.end(); // places change
    this.store.setLayers((before) => {
      const layers = [...before];
      layers.splice(at + by, 0, ...layers.splice(at, 1));
      return layers;
    });
  }

  override render() {
    const own = this.store.item?.content;
    const sources = sourcesOf(this.store, "expression").map((source) =>
      source.source === own ? { ...source, label: `${source.label}, as it was saved (a copy)` } : source,
    );
    const add = (source: string): void => {
      if (source === "") return;
      const label = labelOf(sources, source);
      if (
        this.#layers.some((existing) => existing.source === source && existing.region === null && !existing.mirrored)
      ) {
        this.store.say(
          `"${label}" is a layer already, on the whole face: give that one more weight, or a region of its own.`,
        );
        return;
      }
      const layer: Layer = { source, label, weight: 1, region: null, mirrored: false, muted: false };
      this.store.setLayers((layers) => [...layers, layer]);
      if (source === own)
        this.store.say(`"${label}" now counts twice: as a layer and as the needles here. Give the layer less weight.`);
    };
    return html`
      <p>Expressions that lie under your needles and add up: the brow of one, the mouth of another.</p>
      ${sourceChoice(sources, { label: "Add a layer", first: "+ Add an expression as a layer…", chosen: add })}
      <ul>
        ${repeat(
          this.#layers,
          (layer, at) => `${at} ${layer.source}`,
          (layer, at) => this.#layer(layer, at),
        )}
      </ul>
      ${this.#layers.length === 0 ? nothing : this.#bake()}
    `;
  }

  #layer(layer: Layer, at: number) {
    const { solo } = this.store.layerPreview;
    const silent = solo.size > 0 ? !solo.has(at) : layer.muted;
    return html`<li class="card ${silent ? "silent" : ""}" data-layer=${at}>
      <div class="row">
        <span class="name grow">${layer.label}</span>
        <button class="icon quiet switch mute" aria-pressed=${layer.muted} aria-label="Mute ${layer.label}"
          title="Mute: keeps this layer, and leaves it out of the expression and of what is saved"
          @click=${() => this.#change(at, { muted: !layer.muted })}>M</button>
        <button class="icon quiet switch" aria-pressed=${solo.has(at)} aria-label="Solo ${layer.label}"
          title="Solo: shows this layer alone, on this page only; nothing is changed"
          @click=${() => this.store.layerPreview.toggleSolo(at)}>S</button>
        <button class="icon quiet" title="Move up" aria-label="Move ${layer.label} up" ?disabled=${at === 0}
          @click=${() => this.#move(at, -1)}>↑</button>
        <button class="icon quiet" title="Move down" aria-label="Move ${layer.label} down"
          ?disabled=${at === this.#layers.length - 1} @click=${() => this.#move(at, 1)}>↓</button>
        <button class="icon quiet" title="Take this layer away" aria-label="Remove ${layer.label}"
          @click=${() => this.#remove(at)}>✕</button>
      </div>
      <omote-amount label="Weight" .unit=${PERCENT} .low=${-0.5} .high=${1.5} .value=${layer.weight}
        hint="How much of it; below zero the opposite"
        @live=${(event: Event) => this.#try(at, { weight: amountOf(event) })}
        @done=${(event: Event) => this.#change(at, { weight: amountOf(event) })}></omote-amount>
      <div class="row">
        <select class="grow" aria-label="Region of ${layer.label}" title="Only this part of the face"
          @change=${(event: Event) => this.#change(at, { region: textOf(event) || null })}>
          <option value="" .selected=${live(layer.region === null)}>Whole face</option>
          ${this.store.regions.map(
            (region) =>
              html`<option value=${region} .selected=${live(region === layer.region)}>Only ${region}</option>`,
          )}
        </select>
        <label class="row" title="Left and right exchanged"><input type="checkbox" .checked=${layer.mirrored}
          @change=${() => this.#change(at, { mirrored: !layer.mirrored })} /> mirrored</label>
      </div>
    </li>`;
  }

  #remove(at: number): void {
    this.store.layerPreview.end(); // places change
    this.store.setLayers((layers) => layers.filter((_, place) => place !== at));
  }

  #bake() {
    const muted = this.#layers.filter((layer) => layer.muted).length;
    return html`<button ?disabled=${muted === this.#layers.length}
      title="Layers, muscles and needles become one field; the needles then stand at rest on it; muted layers stay as they are"
      @click=${() => bake(this.store)}>${muted === 0 ? "Bake into one" : `Bake all but ${muted} muted into one`}</button>`;
  }
}

/** The layers with one of them changed. */
const changed = (layers: readonly Layer[], at: number, change: Partial<Layer>): Layer[] =>
  layers.map((layer, place) => (place === at ? { ...layer, ...change } : layer));
