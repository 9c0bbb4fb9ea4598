/** The list of what is on air on one axis, heaviest first. */

import { css, html, nothing } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import type { CallState, CharacterState } from "../../link/messages";
import { base, ellipsis, emptyBar, thinBar } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";
import { short } from "../controls/screen_sizes";
import { type Axis, onAir } from "../store/axis";
import { regionalMixes } from "../store/region_calls";
import { remainingLabel } from "../store/timing";
import "./answers";

const ROWS = 4;

const style = css`
  :host {
    display: grid;
    grid-template-rows: auto 1fr auto;
    gap: 4px;
    padding: 8px 10px;
    min-width: 0;
  }
  header {
    display: flex;
    align-items: center;
    justify-content: space-between;
    gap: 6px;
    min-width: 0;
  }
  header button {
    padding: 0 7px;
    font-size: 11px;
    white-space: nowrap;
  }
  header button span {
    display: none;
  }
  .rows {
    display: var(--lists, grid);
    align-content: start;
    gap: 3px;
    min-height: 76px;
  }
  .row {
    position: relative;
    display: flex;
    align-items: center;
    gap: 6px;
    height: 17px;
    padding: 0 6px;
    border-radius: 3px;
    overflow: hidden;
    background: #000;
  }
  .row.none {
    visibility: hidden;
  }
  .row i {
    ${emptyBar}
    background: var(--air-deep);
    border-right: 2px solid var(--air);
  }
  .row.target i {
    background: var(--coming-deep);
  }
  .row b {
    position: relative;
    flex: 1;
    font-size: 12px;
    font-weight: 600;
    ${ellipsis}
  }
  .row span {
    position: relative;
    font-size: 12px;
  }
  .coming {
    position: relative;
    display: var(--lists, flex);
    gap: 6px;
    align-items: center;
    height: 24px;
    padding: 0 8px;
    border-radius: 3px;
    border: 1px solid var(--line);
    color: var(--faint);
    overflow: hidden;
  }
  .coming.shown {
    color: var(--coming);
    border-color: var(--coming);
  }
  .what {
    flex: 1;
    font-weight: 600;
    ${ellipsis}
  }
  .progress {
    ${thinBar}
    background: var(--coming);
  }
  @media (pointer: fine) {
    header button {
      height: 20px;
      min-height: 0;
    }
  }
  @media ${short} {
    .rows,
    .coming {
      display: none; /* the T-bars beside the picture name both ends */
    }
    :host {
      padding: 2px 6px;
    }
    h2 {
      display: none;
    }
    header button {
      flex: 1;
      min-width: 0;
      padding: 0;
      overflow: hidden;
      text-overflow: ellipsis;
    }
    header button span {
      display: inline;
    }
  }
`;

/** What is on air on one axis, heaviest first, and what is coming. */
@customElement("omote-mix")
export class OnAirMix extends AnimatedElement {
  @property() axis: Axis = "face";
  @query(".rows") private rows!: HTMLElement;
  @query(".coming") private coming!: HTMLElement;
  @query(".what") private what!: HTMLElement;
  @query(".left") private left!: HTMLElement;
  @query(".progress") private progress!: HTMLElement;

  static override styles = [base, style];

  override render() {
    return html`
      <header>
        <h2>${this.axis === "face" ? "Face" : "Expression"}</h2>
        ${this.axis === "face" ? html`<omote-answers .context=${this.context}></omote-answers>` : nothing}
        <button
          data-keep=${this.axis}
          aria-label="Keep ${this.axis}"
          title="Keep what is on air as a new ${this.axis} (${this.axis === "face" ? "N" : "M"})"
          @click=${() => this.context.items.keep(this.axis)}
        >
          Keep<span> ${this.axis === "face" ? "face" : "expr."}</span>
        </button>
      </header>
      <div class="rows" data-axis=${this.axis}>
        ${Array.from({ length: ROWS }, () => html`<div class="row none"><i></i><b></b><span></span></div>`)}
      </div>
      <div class="coming"><span class="what"></span><span class="left"></span><span class="progress"></span></div>
    `;
  }

  paint(): void {
    const state = this.store.air;
    const [call, region] = this.#call;
    const whole = onAir((this.axis === "face" ? state?.faces : state?.expressions) ?? {});
    const names = this.axis === "face" || state === null ? whole : [...whole, ...this.#regional(state)];
    const { write } = this;
    for (const [index, row] of [...this.rows.children].entries()) {
      const [name, weight, where = ""] = names[index] ?? ["", 0];
      const [label, more] = [`${where}${this.store.label(this.axis, name)}`, names.length - ROWS];
      write.flag(row, "none", name === "");
      write.flag(row, "target", name === call?.target);
      write.style(row.children[0] as HTMLElement, "transform", `scaleX(${Math.abs(weight).toFixed(3)})`);
      write.text(row.children[1] as Element, index === ROWS - 1 && more > 0 ? `${label} + ${more} more` : label);
      write.text(row.children[2] as Element, name === "" ? "" : String(Math.round(weight * 100)));
    }
    write.flag(this.coming, "shown", call !== null);
    write.text(this.what, call === null ? "nothing coming" : `▶ ${region}${this.store.label(this.axis, call.target)}`);
    write.text(
      this.left,
      call === null ? "" : call.remaining === null ? "by hand" : `${remainingLabel(call.remaining)} s`,
    );
    write.style(this.progress, "transform", `scaleX(${(call?.progress ?? 0).toFixed(3)})`);
  }

  /** The call that is told, and the region that it is for: of the whole face where there is one. */
  get #call(): [CallState | null, string] {
    const whole = this.store.callOf(this.axis);
    const [first] = this.axis === "face" ? [] : Object.entries(this.store.air?.region_calls ?? {});
    return whole !== null || first === undefined ? [whole, ""] : [first[1], `${first[0]}: `];
  }

  #regional(state: CharacterState): [string, number, string][] {
    return regionalMixes(state).map(([region, name, weight]) => [name, weight, `${region}: `]);
  }
}
