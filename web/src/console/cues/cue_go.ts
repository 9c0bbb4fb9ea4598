/** What GO plays next, GO itself, and its kin. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { styleMap } from "lit/directives/style-map.js";
import { pressed } from "../../ui/gestures";
import { base } from "../../ui/theme";
import { CueElement, colourOf, warning } from "./cue_element";
import type { CueTopic } from "./cue_store";
import { goesOnWords } from "./cue_words";

const style = css`
  :host {
    display: grid;
    grid-template-columns: minmax(0, 1fr);
    gap: 8px;
    padding: 10px 12px;
  }
  .next {
    min-height: 70px;
    padding-left: 8px;
    border-left: 6px solid transparent;
    overflow: hidden;
  }
  .next b {
    font-size: 22px;
    color: var(--coming);
  }
  .note {
    margin-top: 2px;
    font-size: 15px;
    white-space: pre-line;
    overflow-wrap: anywhere;
  }
  .by-itself {
    margin-top: 2px;
    color: var(--coming);
  }
  .keys {
    display: grid;
    grid-template-columns: repeat(3, minmax(0, 1fr));
    gap: 6px;
  }
  .keys button {
    min-height: 46px;
    padding: 0 4px;
    font-size: 15px;
    font-weight: 600;
    touch-action: manipulation;
  }
  .keys button:not([aria-pressed="true"]) {
    color: var(--text);
  }
  .go {
    display: grid;
    place-content: center;
    min-height: 150px;
    padding: 4px;
    overflow: hidden;
    font-size: 64px;
    font-weight: 800;
    line-height: 1;
    color: #03150a;
    background: var(--coming);
    border: 0;
    border-radius: 10px;
    touch-action: none;
  }
  .go:hover {
    color: #03150a;
  }
  .go:active {
    background: #7df0ae;
  }
  .go small {
    display: block;
    font-size: 26px;
  }
  .go.deaf,
  .go.end,
  .go.typing {
    color: var(--text);
    background: #2a2d31;
  }
  .go.deaf {
    text-decoration: line-through;
    outline: 3px solid #c3170a;
    outline-offset: -3px;
  }
  .go.typing span {
    font: 600 13px / 1.2 system-ui, sans-serif;
    text-align: center;
  }
  .go.paused {
    background: var(--attention);
  }
  .go small {
    font-weight: 700;
    letter-spacing: 0.1em;
  }
  .go.paused small {
    font-size: 0.7em;
    letter-spacing: 0;
  }
  .panicked {
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    gap: 6px;
  }
  .panicked button {
    color: inherit;
    background: none;
    border: 0;
  }
  :host([compact]) {
    grid-template-columns: minmax(0, 5fr) minmax(0, 4fr);
  }
  :host([compact]) .next {
    grid-column: 1 / -1;
    min-height: 0;
    max-height: 52px;
  }
  .arm {
    min-height: 34px;
    color: var(--text);
  }
  @media (pointer: coarse) {
    .arm {
      min-height: 44px;
    }
  }
  .arm[aria-pressed="true"] {
    color: #1c1500;
    background: var(--attention);
  }
  :host([compact]) :is(.warning, .arm) {
    grid-column: 1 / -1;
  }
  :host([compact]) .next b {
    font-size: 17px;
  }
  :host([compact]) .go {
    min-height: 84px;
    font-size: 40px;
  }
  :host([compact]) .go:not(.paused) small {
    font-size: 18px;
  }
  :host([compact]) .keys button {
    min-height: 84px;
    padding: 0;
    font-size: 13px;
  }
  @media (max-width: 720px) {
    :host {
      gap: 5px;
      padding: 6px 8px calc(6px + env(safe-area-inset-bottom));
    }
    .next {
      min-height: 0;
      max-height: 84px;
    }
    .next b {
      font-size: 18px;
    }
    .go {
      min-height: 120px;
    }
  }
`;

@customElement("omote-cue-go")
export class CueGo extends CueElement {
  static override styles = [base, warning, style];

  protected override readonly topics: readonly CueTopic[] = ["cues", "list", "view", "link"];

  override render() {
    const { ignored, unheard, editing, keysPlay, panicked } = this.cues;
    this.toggleAttribute("compact", editing);
    return html`${this.#next()}
      ${panicked === "" ? nothing : html`<div class="warning panicked" role="alert">${panicked}<button aria-label="Dismiss" title="I have read it" @click=${() => this.cues.forgetPanic()}>✕</button></div>`}
      ${ignored === "" ? nothing : html`<div class="warning ignored" role="alert">${ignored}</div>`}
      ${unheard === "" ? nothing : html`<div class="warning deaf" role="alert">${unheard}</div>`}
      ${editing ? html`<button class="arm" aria-pressed=${keysPlay} title="Lets Space, Shift Space, P, A and ↑ ↓ play while cues are edited, until a field is entered" @click=${() => this.cues.letKeysPlay(!keysPlay)}>Keys play: ${keysPlay ? "ON, Space is GO" : "off while editing"}</button>` : nothing}
      ${this.#keys()}${this.#go()}`;
  }

  #next() {
    const { standby } = this.cues;
    if (standby === null)
      return html`<div class="next">${this.cues.list.length === 0 ? "No cues yet: press New or Record." : "The end of the list: no cue stands by."}</div>`;
    const after = goesOnWords(this.cues.find(standby.identity) ?? { goes_on: "", post_wait: 0 });
    return html`<div class="next" style=${styleMap({ borderColor: colourOf(standby.colour) })}><b>${standby.number} ${this.cues.titleOf(standby)}</b>
      ${after === "" ? nothing : html`<div class="by-itself">${after}</div>`}<div class="note">${standby.note}</div></div>`;
  }

  #keys() {
    const { cues } = this;
    return html`<div class="keys">
      <button title="Back: what stood before the last cue (Shift Space)" ?disabled=${cues.unheard !== ""} @click=${() => cues.back()}>Back</button>
      <button title="The time of cues stands still (P)" aria-pressed=${cues.paused} ?disabled=${cues.unheard !== ""} @click=${() => cues.pause()}>${cues.paused ? "Go on" : "Pause"}</button>
      <button title="All that the cues have left standing, again (A)" ?disabled=${cues.unheard !== ""} @click=${() => cues.assertLook()}>Assert</button>
    </div>`;
  }

  #go() {
    const { standby, paused, unheard, typing } = this.cues;
    const word = paused ? "GO ON" : "GO";
    const number = paused ? "" : (standby?.number ?? "END");
    const look = unheard !== "" ? "deaf" : paused ? "paused" : standby === null ? "end" : typing ? "typing" : "";
    const press = pressed(() => this.cues.go());
    return html`<button class="go ${look}" title="GO (Space)" @pointerdown=${press.down} @click=${press.click}><small>${word}</small>${number}${typing ? html`<span>Space types in a field: Esc</span>` : nothing}</button>`;
  }
}
