/** Where the next calls of expressions go: the whole face, or one region of it alone. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { base } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { ConsoleElement } from "../controls/console_element";
import type { Topic } from "../store/page_store";
import { PLACES, type PlayRegion } from "../store/region_calls";

const WHOLE = "whole";
const labelOf = (place: PlayRegion | null): string => place ?? WHOLE;
const TITLE = "Where the next expressions are called: on the whole face, or in one region of it, in its own time (D)";

const style = css`
  :host {
    display: flex;
    min-width: 0;
    container-type: inline-size;
  }
  .row {
    display: flex;
    flex: 1;
    gap: 2px;
    min-width: 0;
  }
  button {
    flex: 1 1 0;
    min-width: 0;
    padding: 0 2px;
    font-size: 12px;
  }
  select {
    display: none;
    width: 100%;
    min-width: 0;
  }
  select.chosen {
    border-color: var(--hand);
    color: var(--hand);
  }
  @container (max-width: 220px) {
    .row {
      display: none;
    }
    select {
      display: block;
    }
  }
  @container (max-width: 60px) {
    select {
      appearance: none; /* no arrow: the region is read in full */
      padding: 0 3px;
      text-align: center;
    }
  }
  @media (pointer: coarse) {
    .row {
      display: none;
    }
    select {
      display: block;
    }
  }
`;

/** The whole face or a region, as buttons; where there is little room and for fingers as a list. */
@customElement("omote-regions")
export class RegionRow extends ConsoleElement {
  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["timing"];

  override render() {
    const { region } = this.store;
    return html`<div class="row" role="radiogroup" aria-label="Where expressions are called" title=${TITLE}>
        ${PLACES.map(
          (place) => html`<button role="radio" data-region=${labelOf(place)} aria-checked=${place === region}
            @click=${() => this.store.chooseRegion(place)}>${labelOf(place)}</button>`,
        )}
      </div>
      <select class=${region === null ? "" : "chosen"} aria-label="Where expressions are called" title=${TITLE} @change=${this.#chosen}>
        ${PLACES.map((place) => html`<option value=${labelOf(place)} .selected=${place === region}>${labelOf(place)}</option>`)}
      </select>`;
  }

  readonly #chosen = (event: Event): void => {
    const chosen = textOf(event);
    this.store.chooseRegion(PLACES.find((place) => labelOf(place) === chosen) ?? null);
  };
}
