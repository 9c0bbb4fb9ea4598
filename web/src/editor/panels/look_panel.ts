/** The panel that chooses the look of a face: hair, brows, skin, eyes, lips, lashes. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import type { FaceRecipe } from "../../link/editing_messages";
import type { FaceDocument, Manifest } from "../../link/messages";
import { base } from "../../ui/theme";
import { THUMBNAIL_SIZE } from "../../ui/thumbnails";
import { textOf } from "../../ui/topic_element";
import { amountWithin } from "../controls/amount";
import { controls, panel } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import { PERCENT } from "../controls/units";
import { loadFace } from "../session/asset_loading";
import type { Topic } from "../session/draft_store";
import { hairOf } from "../session/thumbnail_renderer";
import { COLOURS, GARMENT_PART, LOOK_PARTS, type LookPart, type Trait } from "./look_parts";

const style = css`
  .tiles {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(72px, 1fr));
    gap: 5px;
  }
  .tile {
    padding: 0;
    overflow: hidden;
    background: #000;
  }
  .tile[aria-pressed="true"] {
    border-color: var(--coming);
  }
  .tile canvas {
    display: block;
    width: 100%;
    aspect-ratio: 13 / 12;
  }
  .tile span {
    display: block;
    padding: 2px;
    font-size: 11px;
  }
  .head {
    display: flex;
    align-items: center;
    justify-content: space-between;
    min-height: 30px;
  }
  .head button:disabled {
    visibility: hidden;
  }
  .colour {
    display: flex;
    flex-wrap: wrap;
    gap: 4px;
  }
  .colour > span {
    flex-basis: 100%;
    font-size: 12.5px;
    color: var(--dim);
  }
  .swatch {
    min-width: 26px;
    min-height: 26px;
    padding: 0;
  }
  .swatch[aria-pressed="true"] {
    border: 2px solid var(--text);
  }
  input[type="color"] {
    width: 34px;
    height: 28px;
    padding: 0;
    border: 1px solid var(--edge);
    background: none;
  }
`;

/** What of a look is its hair. */
const HAIR = ["hair_style", "scalp", "hair"];

/** What a face looks like, part by part; what is not chosen is as its faces bring it. */
@customElement("omote-look")
export class LookPanel extends EditorElement {
  static override styles = [base, controls, panel, style];

  /** The face as the server baked it last: what is not chosen is read here. */
  @state() private baked: FaceDocument | null = null;
  #asked = "";

  protected override readonly topics: readonly Topic[] = ["draft", "cast"];

  override willUpdate(): void {
    const { manifest, draft, face } = this.store;
    const content = draft?.content ?? "";
    if (manifest === null || face === null || content === this.#asked) return;
    this.#asked = content;
    loadFace(manifest, content).then(
      ({ document }) => {
        if (this.#asked === content) this.baked = document;
      },
      () => undefined, // what was chosen is shown without it
    );
  }

  override updated(): void {
    const face = this.baked?.source;
    if (face === undefined) return;
    for (const canvas of this.renderRoot.querySelectorAll<HTMLCanvasElement>("canvas"))
      this.context.thumbnails.ask(canvas, { face, expression: "neutral", hair: canvas.dataset.style ?? "" });
  }

  #choose(chosen: FaceRecipe["look"], what: string): void {
    this.store.setFace((recipe) => ({ ...recipe, look: { ...recipe.look, ...chosen } }), what);
  }

  #leave(names: readonly string[], what: string): void {
    const without = ({ look }: FaceRecipe) =>
      Object.fromEntries(Object.entries(look).filter(([name]) => !names.includes(name)));
    this.store.setFace((recipe) => ({ ...recipe, look: without(recipe) }), what);
  }

  /** A colour or number as it is now; undefined where nobody knows yet. */
  #value(name: string): string | number | undefined {
    return this.store.face?.look[name] ?? this.baked?.look[name as keyof FaceDocument["look"]];
  }

  override render() {
    if (this.store.face === null) return nothing;
    return html`
      ${(this.baked?.albedo ?? "") === "" ? nothing : html`<p class="note">A picture lies on this skin: it hides the colours of skin, lips and brows below.</p>`}
      ${this.#heading("Hair", HAIR)}
      <div class="tiles" role="group" aria-label="Hair style">${["", ...this.#styles].map((name) => this.#style(name))}</div>
      ${LOOK_PARTS.map((part) => this.#part(part))}
      ${this.#garments()}
    `;
  }

  get #styles(): readonly string[] {
    return (this.store.manifest?.hair ?? []).map(({ name }) => name);
  }

  #style(name: string) {
    const label = name === "" ? "none" : name;
    return html`<button class="tile" data-hair=${label} aria-pressed=${this.#value("hair_style") === name} title="Hair: ${label}"
      @click=${() => this.#choose(hairOf(this.store.manifest as Manifest, name), `hair: ${label}`)}>
      <canvas data-style=${name} width=${THUMBNAIL_SIZE.width} height=${THUMBNAIL_SIZE.height} aria-hidden="true"></canvas>
      <span>${label}</span>
    </button>`;
  }

  /** What a figure wears; nothing where the cast has no figures. */
  #garments() {
    const garments = this.store.manifest?.figures?.garments ?? [];
    if (garments.length === 0) return nothing;
    const parts = [...GARMENT_PART.colours, ...GARMENT_PART.traits].map(({ name }) => name);
    return html`${this.#heading(GARMENT_PART.title, ["garment", ...parts])}
      <div class="row" role="group" aria-label="Garment">${garments.map(
        ({ name, label }) => html`<button data-garment=${name} aria-pressed=${this.#value("garment") === name}
          @click=${() => this.#choose({ garment: name }, `garment: ${label.toLowerCase()}`)}>${label}</button>`,
      )}</div>
      ${this.#part({ ...GARMENT_PART, title: "" })}`;
  }

  #part({ title, colours, traits }: LookPart) {
    const names = [...colours, ...traits].map(({ name }) => name);
    return html`${title === "" ? nothing : this.#heading(title, names)}
      ${colours.map(({ name, label, kind }) => this.#colour(name, label, COLOURS[kind]))}
      ${traits.map((trait) => this.#amount(trait))}`;
  }

  /** The name of a part, and what takes back what was chosen of it: there always, so that nothing moves under a finger. */
  #heading(title: string, names: readonly string[]) {
    const isChosen = names.some((name) => name in (this.store.face?.look ?? {}));
    return html`<div class="head"><h2>${title}</h2><button class="quiet" ?disabled=${!isChosen} aria-label="${title} as its faces have it"
      title="Takes back what was chosen of it" @click=${() => this.#leave(names, `${title.toLowerCase()} of its faces`)}>As its faces</button></div>`;
  }

  #colour(name: string, label: string, swatches: readonly (readonly [string, string])[]) {
    const now = this.#value(name);
    return html`<div class="colour" role="group" aria-label=${label} data-colour=${name}><span aria-hidden="true">${label}</span>
      ${swatches.map(
        ([colour, called]) => html`<button class="swatch" style="background: ${colour}" title="${label}: ${called}"
          aria-label="${label}: ${called}" aria-pressed=${now === colour}
          @click=${() => this.#choose({ [name]: colour }, `${label.toLowerCase()}: ${called}`)}></button>`,
      )}
      <input type="color" aria-label="${label}: another" title="${label}: another" .value=${String(now ?? "#000000")}
        @change=${(event: Event) => this.#choose({ [name]: textOf(event) }, label.toLowerCase())} />
    </div>`;
  }

  #amount({ name, label, hint, low = 0, high = 1 }: Trait) {
    const value = Number(this.#value(name) ?? 0);
    return html`<omote-amount data-trait=${name} label=${label} hint=${hint} .unit=${PERCENT} .low=${low} .high=${high} .value=${value}
      @done=${(event: Event) => this.#choose({ [name]: amountWithin(event, low, high) }, label.toLowerCase())}></omote-amount>`;
  }
}
