/** The panel with the numbers of the selected control points. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { base } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { controls, panel } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import { DEGREES, MILLIMETRES, RATIO, shown, typed, type Unit } from "../controls/units";
import { REST, split, type Vector } from "../session/control_net";
import type { Topic } from "../session/draft_store";
import { commonOf, mirrored } from "./point_values";

const ENTRIES: readonly (readonly [string, Unit, string])[] = [
  ["Turn", DEGREES, "Δθ: around the head, + towards the character's left"],
  ["Height", MILLIMETRES, "Δh: along the head's axis, + up"],
  ["Off the skin", RATIO, "1 on the skin, more outside, less inside (R in the method)"],
];

const style = css`
  .entry {
    display: grid;
    grid-template-columns: 1fr 96px 22px;
    align-items: center;
    gap: 8px;
  }
  .entry input {
    text-align: right;
  }
  b {
    color: var(--text);
  }
`;

/** The selected needles as numbers, to be read and typed. */
@customElement("omote-points")
export class PointsPanel extends EditorElement {
  static override styles = [base, controls, panel, style];

  protected override readonly topics: readonly Topic[] = ["draft", "live", "selection"];

  override render() {
    const { selection, net } = this.store;
    if (net === null) return html`<p>Open an expression to see its needles.</p>`;
    const places = [...selection];
    return html`
      ${
        places.length === 0
          ? html`<p>Click a needle on the face to read and type its numbers; Shift and click for several.</p>`
          : html`<p><b>${places.length === 1 ? `Needle ${(places[0] as number) + 1}` : `${places.length} needles`}</b>
              of ${net.rows.length}</p>${ENTRIES.map((entry, part) => this.#entry(entry, part, places))}`
      }
      <div class="row">
        <button ?disabled=${places.length === 0} @click=${() => this.#reset(places)}>Reset selected</button>
        <button ?disabled=${places.length === 0} title="What they do is done by their mirror images too"
          @click=${() => this.#mirror(places)}>Copy to the other side</button>
      </div>
      <div class="row">
        <button class="quiet" @click=${() => this.store.select(net.rows.keys())}>Select all</button>
        <button class="quiet" ?disabled=${places.length === 0} @click=${() => this.store.select([])}>Select none</button>
        <button class="quiet" @click=${() => this.#reset([...net.rows.keys()])}>Reset all</button>
      </div>
      ${this.store.draft?.miss ? html`<p class="note">The last drag lies ${shown(this.store.draft.miss, MILLIMETRES)} mm from where it was put.</p>` : nothing}
    `;
  }

  #entry([name, unit, hint]: (typeof ENTRIES)[number], part: number, places: readonly number[]) {
    const value = commonOf(this.store.live, places, part);
    return html`<div class="entry">
      <label for="part${part}" title=${hint}>${name}</label>
      <input id="part${part}" inputmode="decimal" title=${hint} placeholder="several"
        .value=${value === null ? "" : shown(value, unit)}
        @change=${(event: Event) => this.#type(textOf(event), unit, part, places)} />
      <span class="note">${unit.name}</span>
    </div>`;
  }

  #type(text: string, unit: Unit, part: number, places: readonly number[]): void {
    const value = typed(text, unit);
    if (value === null) {
      this.requestUpdate();
      this.store.say(`"${text}" is not a number; type one such as 1.5.`);
      return;
    }
    const vectors = split(this.store.live);
    for (const place of places) (vectors[place] as Vector)[part] = value;
    this.store.setVectors(vectors, "typed numbers");
  }

  #reset(places: readonly number[]): void {
    const vectors = split(this.store.live);
    for (const place of places) vectors[place] = [...REST];
    this.store.setVectors(vectors, "needles reset");
  }

  #mirror(places: readonly number[]): void {
    const { net, live } = this.store;
    if (net !== null) this.store.setVectors(mirrored(split(live), places, net.mirror), "copied to the other side");
  }
}
