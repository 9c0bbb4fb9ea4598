/** The panel that makes a face from faces: a mix, regions, caricature, handles, gains. */

import { html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { live } from "lit/directives/live.js";
import {
  GAIN_REGIONS,
  type Gain,
  type GainRegion,
  gainOf,
  mixGains,
  overrideGains,
  regionalGains,
} from "../../face/pose/gains";
import { GAIN_RANGE } from "../../link/constants";
import type { FaceRecipe, HandlesAsset } from "../../link/editing_messages";
import { base } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { amountWithin } from "../controls/amount";
import { controls, panel } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import { sourceChoice } from "../controls/source_choice";
import { GAIN, MILLIMETRES, PERCENT, shown } from "../controls/units";
import type { Topic } from "../session/draft_store";
import { loadHandles } from "../session/face_handles";
import { normalised, weighed } from "../session/item_commands";
import { type ListedSource, labelOf, sourcesOf } from "../session/sources";

/** How a face is made from faces: a mix, regions from others, caricature, handles; and how strongly it answers. */
@customElement("omote-recipe")
export class FaceRecipePanel extends EditorElement {
  static override styles = [base, controls, panel];

  /** What the head's handles are called; null until the server has told. */
  @state() private handles: HandlesAsset | null = null;

  /** Where the next gain for one expression goes. */
  @state() private region: GainRegion = "mouth";

  protected override readonly topics: readonly Topic[] = ["draft", "items", "cast", "selection"];

  override firstUpdated(): void {
    loadHandles().then(
      (handles) => {
        this.handles = handles;
      },
      () => undefined, // numbers do for names
    );
  }

  /** `change`: what changes, from the recipe as it is when the steps before are done. */
  #set(change: (recipe: FaceRecipe) => Partial<FaceRecipe>, what: string): void {
    this.store.setFace((recipe) => ({ ...recipe, ...change(recipe) }), what);
  }

  override render() {
    const recipe = this.store.face;
    if (recipe === null) return nothing;
    const sources = sourcesOf(this.store, "face").filter(({ source }) => source !== this.store.item?.content);
    return html`
      ${this.#mix(recipe, sources)} ${this.#regions(recipe, sources)}
      <h2>Caricature</h2>
      <omote-amount label="Exaggerate" .unit=${PERCENT} .low=${1} .high=${2} .value=${recipe.amount}
        hint="How far its own traits are taken; 100 % as it is"
        @done=${(event: Event) => {
          const amount = amountWithin(event, 1, 2);
          this.#set(() => ({ amount }), "caricature");
        }}></omote-amount>
      ${this.#handles(recipe)} ${this.#gains(recipe)}
    `;
  }

  #mix({ base: mix }: FaceRecipe, sources: readonly ListedSource[]) {
    const isSingle = Object.keys(mix).length === 1;
    const put = (change: (mix: FaceRecipe["base"]) => FaceRecipe["base"]): void =>
      this.#set((before) => ({ base: normalised(change(before.base)) }), "mix of faces");
    const weigh = (source: string, weight: number): void => put((before) => weighed(before, source, weight));
    return html`<h2>Mix of faces</h2>
      ${Object.entries(mix).map(
        ([source, weight]) => html`<div class="row">
          <omote-amount class="grow" label=${labelOf(sources, source, this.store.items)} .unit=${PERCENT} .value=${weight} ?disabled=${isSingle}
            @done=${(event: Event) => weigh(source, amountWithin(event, 0, 1))}></omote-amount>
          <button class="icon quiet" ?disabled=${isSingle} title="Without it" aria-label="Without ${labelOf(sources, source, this.store.items)}"
            @click=${() => put((before) => Object.fromEntries(Object.entries(before).filter(([name]) => name !== source)))}>✕</button>
        </div>`,
      )}
      ${sourceChoice(
        sources.filter(({ source }) => !(source in mix)),
        {
          label: "Mix in a face",
          first: "+ mix in a face…",
          chosen: (source) =>
            source === "" ? undefined : put((before) => ({ ...before, [source]: 1 / Object.keys(before).length })),
        },
      )}`;
  }

  #regions({ regions }: FaceRecipe, sources: readonly ListedSource[]) {
    const chosen = (region: string, source: string): void => {
      this.#set(({ regions: before }) => {
        const others = Object.fromEntries(Object.entries(before).filter(([name]) => name !== region));
        return { regions: source === "" ? others : { ...others, [region]: source } };
      }, `${region} of another`);
    };
    return html`<h2>Parts of others</h2>
      ${this.store.regions.map(
        (region) => html`<div class="row"><span style="width: 64px">${region}</span>
          ${sourceChoice(sources, {
            label: `Where the ${region} come from`,
            first: "–",
            value: regions[region] ?? "",
            chosen: (source) => chosen(region, source),
          })}</div>`,
      )}`;
  }

  /** The handles that were moved; those at rest stay in the recipe, for the others hold on to them. */
  #handles({ points, moves }: FaceRecipe) {
    const far = (move: readonly number[]): number => Math.hypot(...move);
    const moved = moves.flatMap((move, at) => (far(move) > 0 ? [at] : []));
    const reset = (places: readonly number[]): void =>
      this.#set(
        (before) => ({ moves: before.moves.map((move, at) => (places.includes(at) ? [0, 0, 0] : move)) }),
        "handles back at rest",
      );
    return html`<h2>Handles</h2>
      <p class="note">${moved.length === 0 ? "None moved yet: drag one on the face. " : nothing}With Alt held it goes to and fro, along your view.</p>
      <ul>${moved.map(
        (at) => html`<li class="row">
          <button class="grow" aria-pressed=${this.store.selection.has(at)} title="Choose it"
            @click=${() => this.store.select([at])}>${this.#label(points[at] ?? -1, at)}: ${shown(far(moves[at] ?? []), MILLIMETRES)} mm</button>
          <button class="icon quiet" title="Back where it was" aria-label="Reset ${this.#label(points[at] ?? -1, at)}"
            @click=${() => reset([at])}>✕</button></li>`,
      )}</ul>
      ${moved.length < 2 ? nothing : html`<button @click=${() => reset(moved)}>All handles back</button>`}`;
  }

  /** One fader per region, and one for each gain of a single expression; double-click: as its faces answer. */
  #gains(recipe: FaceRecipe) {
    const faces = this.store.manifest?.faces ?? [];
    const inherited = inheritedGains(recipe, (source) => faces.find((face) => face.source === source)?.gains ?? []);
    const now = overrideGains(inherited, recipe.gains);
    const named = [...inherited, ...recipe.gains].filter(({ expression }) => expression !== null);
    const single = [...new Map(named.map((gain) => [`${gain.region}:${gain.expression}`, gain])).values()];
    return html`<h2>How strongly it answers</h2>
      <p class="note">1 as every expression says, 0 not at all. Ears and head turn only where a face sets them.</p>
      ${GAIN_REGIONS.map((region) => this.#gain({ region, value: gainOf(now, region), expression: null }, inherited))}
      ${single.map((gain) => this.#gain(gain, inherited))}
      ${this.#oneExpression(now)}
      ${recipe.gains.length === 0 ? nothing : html`<button @click=${() => this.#set(() => ({ gains: [] }), "gains of its faces")}>As its faces answer</button>`}`;
  }

  #gain(gain: Gain, inherited: readonly Gain[]) {
    const { region, expression } = gain;
    const name = expression === null ? titled(region) : `${titled(region)}, ${this.#expressionLabel(expression)}`;
    const done = (event: Event): void => {
      const value = amountWithin(event, ...GAIN_RANGE);
      this.#set(withGain({ region, expression, value }), `gain of ${name.toLowerCase()}`);
    };
    return html`<omote-amount data-gain="${region}${expression === null ? "" : `:${expression}`}" label=${name} .unit=${GAIN}
      .low=${GAIN_RANGE[0]} .high=${GAIN_RANGE[1]} .value=${gain.value} .rest=${gainOf(inherited, region, expression)}
      hint="How strongly ${expression === null ? "it answers all expressions" : "it answers this expression"} here" @done=${done}></omote-amount>`;
  }

  /** Adds a gain for one expression, in the region that is chosen first. */
  #oneExpression(now: readonly Gain[]) {
    const region = this.region;
    const sources = sourcesOf(this.store, "expression").filter(({ source }) => !source.startsWith("#"));
    return html`<div class="row">
      <select aria-label="Region of a gain for one expression" @change=${(event: Event) => (this.region = textOf(event) as GainRegion)}>${GAIN_REGIONS.map((name) => html`<option value=${name} .selected=${live(name === region)}>${titled(name)}</option>`)}</select>
      ${sourceChoice(sources, {
        label: "A gain for one expression",
        first: "+ for one expression…",
        chosen: (source) => {
          const value = gainOf(now, region) === 1 ? 1.5 : 1; // what says nothing new would be left out
          if (source !== "") this.#set(withGain({ region, value, expression: source }), "gain of one expression");
        },
      })}</div>`;
  }

  #expressionLabel(name: string): string {
    return this.store.manifest?.expressions.find((expression) => expression.name === name)?.label ?? name;
  }

  #label(row: number, at: number): string {
    return this.handles?.labels[this.handles.points.indexOf(row)] ?? `handle ${at + 1}`;
  }
}

/** Puts a gain in the place of the one for the same region and expression. */
const withGain =
  (gain: Gain) =>
  ({ gains }: FaceRecipe): Partial<FaceRecipe> => {
    const others = gains.filter((other) => other.region !== gain.region || other.expression !== gain.expression);
    return { gains: [...others, gain] };
  };

const titled = (name: string): string => name[0]?.toUpperCase() + name.slice(1);

/** The gains that a recipe's faces bring: mixed as its base, a region's from the face that the region is of. */
function inheritedGains({ base: mix, regions }: FaceRecipe, of: (source: string) => readonly Gain[]): Gain[] {
  const mixed = mixGains(Object.entries(mix).map(([source, share]) => [of(source), share] as const));
  return regionalGains(
    mixed,
    Object.fromEntries(Object.entries(regions).map(([region, source]) => [region, of(source)])),
  );
}
