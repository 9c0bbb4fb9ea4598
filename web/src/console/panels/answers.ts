/** How the faces on air answer expressions: their gains, as a line, and all of them in a list. */

import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { type Gain, gainOf, mixGains } from "../../face/pose/gains";
import { openLayer } from "../../ui/key_presses";
import { base, ellipsis } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";
import { onAir } from "../store/axis";

const style = css`
  :host {
    flex: 1;
    min-width: 0;
  }
  :host([empty]) {
    display: none;
  }
  button {
    width: 100%;
    padding: 0 4px;
    border: 0;
    background: none;
    color: var(--dim);
    font-size: 11px;
    text-align: left;
  }
  button span {
    display: block;
    ${ellipsis}
  }
  .short {
    text-align: center;
  }
  @media (max-width: 1100px) {
    :host {
      flex: 0 0 40px;
    }
    button {
      padding: 0;
    }
  }
  .list {
    position: fixed;
    z-index: 5;
    display: grid;
    grid-template-columns: 1fr auto;
    gap: 3px 14px;
    width: 216px;
    box-sizing: border-box;
    overflow: auto;
    padding: 10px 12px;
    border: 1px solid var(--edge);
    border-radius: 4px;
    background: var(--raised);
  }
  h3,
  p {
    grid-column: 1 / -1;
    margin: 0;
    font-size: 12px;
  }
  p {
    color: var(--dim);
  }
  @media (pointer: fine) {
    button {
      height: 20px;
      min-height: 0;
    }
  }
`;

/** The gains of the mix on air (the mean of the faces' by their weights); nothing shows where all are a person's. */
@customElement("omote-answers")
export class AnswersPanel extends AnimatedElement {
  @state() private gains: readonly Gain[] = [];
  @state() private faces = "";
  @state() private open = false;
  /** Nothing is to be read: it takes no room. */
  @property({ type: Boolean, reflect: true }) empty = true;
  #shown = "";
  #takeAway = (): void => undefined;

  static override styles = [base, style];

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#close();
  }

  override render() {
    if (this.empty) return nothing;
    const line = this.gains.map((gain) => `${this.#where(gain)} ${times(gain)}`).join(", ");
    return html`<button aria-expanded=${this.open} aria-label="${this.faces} answers: ${line}" title="${this.faces} answers: ${line}"
        @click=${this.#toggle}><span class="short">gains</span></button>
      ${this.open ? this.#list() : nothing}`;
  }

  #list() {
    const { left, top, bottom } = this.getBoundingClientRect();
    const below = innerHeight - bottom >= top; // on the side with more room, and no higher than that
    const side = below ? `top: ${bottom + 4}px` : `bottom: ${innerHeight - top + 4}px`;
    const room = (below ? innerHeight - bottom : top) - 12;
    const place = `left: ${Math.max(4, Math.min(left, innerWidth - 220))}px; ${side}; max-height: ${room}px`;
    return html`<div class="list" role="dialog" aria-label="How ${this.faces} answers" style=${place}>
      <h3>${this.faces} answers</h3>
      ${this.gains.map((gain) => html`<span>${this.#where(gain)}</span><b>${times(gain)}</b>`)}
      <p>of what an expression does on a person, and of how far it turns ears and head.</p>
    </div>`;
  }

  #where({ region, expression }: Gain): string {
    return expression === null ? region : `${region} in ${this.store.label("expression", expression).toLowerCase()}`;
  }

  readonly #toggle = (): void => {
    if (this.open) this.#close();
    else this.#show();
  };

  #show(): void {
    this.open = true;
    const layer = openLayer({ element: this, kind: "form", close: () => this.#close() });
    const outside = (event: Event): void => {
      if (!event.composedPath().includes(this)) this.#close();
    };
    document.addEventListener("pointerdown", outside);
    this.#takeAway = () => {
      layer();
      document.removeEventListener("pointerdown", outside);
    };
  }

  #close(): void {
    this.#takeAway();
    this.#takeAway = () => undefined;
    this.open = false;
  }

  /** Renders again only where another line is to be read. */
  paint(): void {
    const mix = onAir(this.store.air?.faces ?? {});
    const documents = new Map(this.store.faces.map((face) => [face.name, face]));
    const gains = mixGains(mix.map(([name, weight]) => [documents.get(name)?.gains ?? [], weight] as const)).filter(
      seen,
    );
    const faces = mix.map(([name]) => this.store.label("face", name)).join(" and ");
    const shown = JSON.stringify([faces, gains.map((gain) => [this.#where(gain), times(gain)])]);
    if (shown === this.#shown) return;
    this.#shown = shown;
    [this.gains, this.faces, this.empty] = [gains, faces, gains.length === 0];
    if (this.empty) this.#close();
  }
}

const times = ({ value }: Gain): string => `×${value.toFixed(1)}`;

/** What would read as a person's is left out: the end of a transition. */
const seen = ({ region, value, expression }: Gain): boolean =>
  expression !== null || Math.abs(value - gainOf([], region)) >= 0.05;
