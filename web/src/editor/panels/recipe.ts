import { html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { base } from "../../console/theme";
import type { FaceRecipe } from "../../link/editing";
import { amountOf } from "../amount";
import { controls, panel } from "../controls_style";
import { normalised } from "../deeds";
import { BenchElement } from "../element";
import { sourceChoice } from "../source_choice";
import { labelOf, type Source, sourcesOf } from "../sources";
import { MILLIMETRES, PERCENT, shown } from "../units";
import type { Topic } from "../workbench";

/** How a face is made from faces: a mix, regions from others, caricature, handles. */
@customElement("omote-recipe")
export class FaceRecipePanel extends BenchElement {
  static override styles = [base, controls, panel];

  protected override topics(): readonly Topic[] {
    return ["draft", "items", "cast"];
  }

  #set(change: Partial<FaceRecipe>, what: string): void {
    const recipe = this.bench.face;
    if (recipe !== null) this.bench.setFace({ ...recipe, ...change }, what);
  }

  override render() {
    const recipe = this.bench.face;
    if (recipe === null) return nothing;
    const sources = sourcesOf(this.bench, "face").filter(({ source }) => source !== this.bench.item?.content);
    return html`
      ${this.#mix(recipe, sources)} ${this.#regions(recipe, sources)}
      <h2>Caricature</h2>
      <omote-amount label="Exaggerate" .unit=${PERCENT} .low=${1} .high=${2} .value=${recipe.amount}
        hint="How far its own traits are taken; 100 % as it is"
        @done=${(event: Event) => this.#set({ amount: Math.min(2, Math.max(1, amountOf(event))) }, "caricature")}></omote-amount>
      ${this.#handles(recipe)}
    `;
  }

  #mix({ base: mix }: FaceRecipe, sources: readonly Source[]) {
    const one = Object.keys(mix).length === 1;
    const put = (weights: FaceRecipe["base"]): void => this.#set({ base: normalised(weights) }, "mix of faces");
    return html`<h2>Mix of faces</h2>
      ${Object.entries(mix).map(
        ([source, weight]) => html`<div class="row">
          <omote-amount class="grow" label=${labelOf(sources, source)} .unit=${PERCENT} .value=${weight} ?disabled=${one}
            @done=${(event: Event) => put({ ...mix, [source]: Math.max(0, amountOf(event)) })}></omote-amount>
          <button class="icon quiet" ?disabled=${one} title="Without it" aria-label="Without ${labelOf(sources, source)}"
            @click=${() => put(Object.fromEntries(Object.entries(mix).filter(([name]) => name !== source)))}>✕</button>
        </div>`,
      )}
      ${sourceChoice(
        sources.filter(({ source }) => !(source in mix)),
        {
          label: "Mix in a face",
          first: "+ mix in a face…",
          chosen: (source) => (source === "" ? undefined : put({ ...mix, [source]: 1 / Object.keys(mix).length })),
        },
      )}`;
  }

  #regions({ regions }: FaceRecipe, sources: readonly Source[]) {
    const chosen = (region: string, source: string): void => {
      const others = Object.fromEntries(Object.entries(regions).filter(([name]) => name !== region));
      this.#set({ regions: source === "" ? others : { ...others, [region]: source } }, `${region} of another`);
    };
    return html`<h2>Parts of others</h2>
      ${this.bench.regions.map(
        (region) => html`<div class="row"><span style="width: 64px">${region}</span>
          ${sourceChoice(sources, {
            label: `Where the ${region} come from`,
            first: "–",
            value: regions[region] ?? "",
            chosen: (source) => chosen(region, source),
          })}</div>`,
      )}`;
  }

  #handles({ points, moves }: FaceRecipe) {
    const far = (move: readonly number[]): string => shown(Math.hypot(...move), MILLIMETRES);
    return html`<h2>Handles</h2>
      ${points.length === 0 ? html`<p class="note">None moved yet: drag one on the face.</p>` : nothing}
      <ul>${moves.map(
        (move, at) => html`<li class="row"><span class="grow">Handle ${at + 1}: ${far(move)} mm</span>
          <button class="icon quiet" title="Back where it was" aria-label="Reset handle ${at + 1}"
            @click=${() =>
              this.#set(
                {
                  points: points.filter((_, place) => place !== at),
                  moves: moves.filter((_, place) => place !== at),
                },
                "handle reset",
              )}>✕</button></li>`,
      )}</ul>`;
  }
}
