/** What faces wear while layers are tried: other weights under a hand, or some of the layers alone (solo). */

import type { Layer, Recipe } from "../../link/editing_messages";
import type { EditorAnswer, Request } from "../link/requests";

/** What is previewed: the layers as they would be, alone or with all else of the draft. */
interface Wanted {
  readonly layers: readonly Layer[];
  readonly alone: boolean;
}

/** What a preview needs of the draft store. */
export interface PreviewedDraft {
  readonly draft: { readonly item: number } | null;
  readonly recipe: Recipe | null;
  ask(request: Request): Promise<EditorAnswer | null>;
  tell(topic: "draft"): void;
}

const STILL: Pick<Recipe, "vectors" | "pulls" | "eyes" | "pupil" | "complexion" | "ground"> = {
  vectors: [],
  pulls: [],
  eyes: [0, 0, 0, 0],
  pupil: 0,
  complexion: [0, 0, 0, 0, 0, 0, 0],
  ground: null,
};

/** Asks for previews, one at a time: while one is on its way only the last wish is kept. */
export class LayerPreview {
  /** What the server made of the last wish, `#` and a key; null: the draft itself is shown. */
  content: string | null = null;
  /** Places of the layers that are shown alone; empty: all are shown. A view of this page, no step of the draft. */
  solo: ReadonlySet<number> = new Set();
  #wanted: Wanted | null = null;
  #asking = false;

  constructor(private readonly store: PreviewedDraft) {}

  /** Shows the draft with these layers, or, in solo, those of them that are to be heard; until the draft changes. */
  show(layers: readonly Layer[]): void {
    this.#wanted = { layers: this.#audible(layers), alone: this.solo.size > 0 };
    void this.#ask();
  }

  /** Lets a layer be shown alone, beside others that are, or no more. */
  toggleSolo(place: number): void {
    const solo = new Set(this.solo);
    if (!solo.delete(place)) solo.add(place);
    this.solo = solo;
    if (solo.size === 0) this.end();
    else this.show(this.store.recipe?.layers ?? []);
    this.store.tell("draft");
  }

  /** Shows the draft again; whether anything else was shown. */
  end(): boolean {
    const shown = this.content !== null || this.solo.size > 0;
    [this.content, this.#wanted, this.solo] = [null, null, new Set()];
    return shown;
  }

  /** The draft has changed: what was tried is in it or gone; solo goes on with the layers as they are. */
  renew(): void {
    this.#wanted = null;
    const layers = this.store.recipe?.layers ?? [];
    this.solo = new Set([...this.solo].filter((place) => place < layers.length));
    if (this.solo.size > 0) this.show(layers);
    else this.content = null;
  }

  /** A recipe as it is shown: in solo nothing but its soloed layers. */
  shown(recipe: Recipe): Recipe {
    return this.solo.size === 0 ? recipe : { ...recipe, ...STILL, layers: [...this.#audible(recipe.layers)] };
  }

  /** In solo a layer is heard though it is muted: who asks for it alone wants to see it. */
  #audible(layers: readonly Layer[]): readonly Layer[] {
    if (this.solo.size === 0) return layers;
    return layers.filter((_, place) => this.solo.has(place)).map((layer) => ({ ...layer, muted: false }));
  }

  async #ask(): Promise<void> {
    if (this.#asking) return;
    this.#asking = true;
    while (this.#wanted !== null && this.store.draft !== null) {
      const wanted: Wanted = this.#wanted;
      const { item } = this.store.draft;
      this.#wanted = null;
      const answer = await this.store.ask({ type: "preview_layers", item, ...wanted, layers: [...wanted.layers] });
      if (answer?.type === "previewed") this.#take(answer.item, answer.content, wanted);
    }
    this.#asking = false;
  }

  #take(item: number, content: string, { layers, alone }: Wanted): void {
    if (item !== this.store.draft?.item || alone !== this.solo.size > 0) return;
    if (!alone && same(layers, this.store.recipe?.layers ?? [])) return; // the draft is there already
    this.content = content;
    this.store.tell("draft");
  }
}

const same = (layers: readonly Layer[], other: readonly Layer[]): boolean =>
  JSON.stringify(layers) === JSON.stringify(other);
