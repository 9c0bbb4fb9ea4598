/** The form that creates an item. */

import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { layerWhileShown } from "../../ui/key_presses";
import { base } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { amountOf } from "../controls/amount";
import { controls } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import { sourceChoice } from "../controls/source_choice";
import { PERCENT } from "../controls/units";
import type { Topic } from "../session/draft_store";
import { create, freeLabel, type Kind } from "../session/item_commands";
import { labelOf, OWN, sourcesOf } from "../session/sources";
import "../controls/amount";

/** Letters that a name may have here. */
const LONGEST = 64;

const style = css`
  form {
    display: grid;
    grid-template-columns: minmax(0, 1fr);
    gap: 8px;
    padding: 10px;
    background: var(--raised);
    border: 1px solid var(--edge);
    border-radius: 6px;
  }
  .source {
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    align-items: center;
  }
`;

/** Where something new begins: neutral, any expression or mix, what is on air now. Tells `close`. */
@customElement("omote-new")
export class NewItem extends EditorElement {
  @property() kind: Kind = "expression";
  @property({ attribute: false }) mix: Readonly<Record<string, number>> = {};
  @state() private label = "";
  @state() private onAir = false;
  static override styles = [base, controls, style];

  protected override readonly topics: readonly Topic[] = ["items", "cast"];

  constructor() {
    super();
    layerWhileShown(this, "form", this.close);
  }

  override firstUpdated(): void {
    this.renderRoot.querySelector("input")?.select();
  }

  /** The name if none is typed. */
  get #proposed(): string {
    const [source] = Object.keys(this.mix);
    const stem = `New ${this.kind}`;
    const proposed = source === undefined ? stem : `My ${this.#nameOf(source)}`.slice(0, LONGEST - 3);
    return freeLabel(this.store, this.kind, proposed);
  }

  /** What a source is called within a name: people's own names stay as they wrote them. */
  #nameOf(source: string): string {
    const sources = sourcesOf(this.store, this.kind);
    const label = labelOf(sources, source);
    return sources.find((listed) => listed.source === source)?.group === OWN ? label : label.toLowerCase();
  }

  override render() {
    const sources = sourcesOf(this.store, this.kind);
    const rest = { face: "Generic face", expression: "Neutral", pose: "Stand" }[this.kind];
    return html`<form @submit=${this.#create} aria-label="New ${this.kind}">
      <h2>New ${this.kind}</h2>
      <input aria-label="Name" maxlength=${LONGEST} .value=${this.label || this.#proposed}
        @input=${(event: Event) => (this.label = textOf(event))} />
      ${
        this.kind === "pose"
          ? nothing
          : html`<label class="row"><input type="checkbox" .checked=${this.onAir}
              @change=${() => (this.onAir = !this.onAir)} /> From what is on air now</label>`
      }
      ${
        this.onAir
          ? nothing
          : html`${this.kind === "pose" ? nothing : Object.entries(this.mix).map(([source, weight]) => this.#part(labelOf(sources, source), source, weight))}
            ${sourceChoice(
              sources.filter(({ source }) => !(source in this.mix)),
              {
                label: "Begin from",
                first: this.#first(rest, sources),
                chosen: (source) => this.#set(source, 1),
              },
            )}`
      }
      <div class="row"><button class="main grow" type="submit">Create</button>
        <button type="button" @click=${this.close}>Cancel</button></div>
    </form>`;
  }

  /** What the choice of a beginning says before anything is chosen in it. */
  #first(rest: string, sources: ReturnType<typeof sourcesOf>): string {
    const [source] = Object.keys(this.mix);
    if (source === undefined) return `${rest}; or choose…`;
    return this.kind === "pose" ? labelOf(sources, source) : "+ mix in…";
  }

  #part(label: string, source: string, weight: number) {
    return html`<div class="source">
      <omote-amount label=${label} .unit=${PERCENT} .value=${weight} @done=${(event: Event) => this.#set(source, amountOf(event))}></omote-amount>
      <button class="icon quiet" type="button" aria-label="Without ${label}" title="Without it" @click=${() => this.#drop(source)}>✕</button>
    </div>`;
  }

  #set(source: string, weight: number): void {
    if (source !== "") this.mix = this.kind === "pose" ? { [source]: 1 } : { ...this.mix, [source]: weight };
  }

  #drop(source: string): void {
    this.mix = Object.fromEntries(Object.entries(this.mix).filter(([other]) => other !== source));
  }

  readonly #create = (event: Event): void => {
    event.preventDefault();
    const label = this.label.trim() || this.#proposed;
    void create(this.store, this.kind, label, { mix: this.onAir ? {} : this.mix, onAir: this.onAir });
    this.close();
  };
}
