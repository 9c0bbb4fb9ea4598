/**
 * What the editor page knows and does: the item under work, what the hand moves before the server has answered, and
 * what is selected and shown. Nothing here touches the page, a socket or a clock.
 */

import type {
  DraftState,
  FaceRecipe,
  ItemDocument,
  Layer,
  PoseRecipe,
  Recipe,
  RevisionDocument,
  ToEditor,
} from "../../link/editing_messages";
import { RecipeSteps } from "../link/recipe_steps";
import type { Ask, EditorAnswer, ItemChange, Request } from "../link/requests";
import { flat, keptPlaces, type Net, readNet, split, type Vector } from "./control_net";
import { EditorStore } from "./editor_store";
import { LayerPreview } from "./layer_preview";

export { type EditorTopic as Topic, MOST_NEIGHBOURS, type Options, type Tool } from "./editor_store";

const PALE: Recipe["complexion"] = [0, 0, 0, 0, 0, 0, 0];
const LOOKING_AHEAD = { turns: [0, 0, 0, 0] as Recipe["eyes"], pupil: 0 };

export class DraftStore extends EditorStore {
  /** The draft of the open item as the server last told it; null while nothing is open. */
  draft: DraftState | null = null;
  /** The net of the draft; null while none is open, and for a face. */
  net: Net | null = null;
  revisions: readonly RevisionDocument[] = [];
  /** Places in the net. */
  selection: ReadonlySet<number> = new Set();
  /** Vectors of the net as the hand has them now, (n, 3): the draft's, and the drag under way. Written by the canvas. */
  live: Float64Array = new Float64Array(0);
  /** Contractions as the hand has them now. */
  livePulls: ReadonlyMap<string, number> = new Map();
  /** What the recipe adds to eyeballs and pupils, as the hand has it now. */
  liveEyes: { readonly turns: Recipe["eyes"]; readonly pupil: number } = LOOKING_AHEAD;
  /** What the recipe adds to blood, tears and sweat, as the hand has it now. */
  liveComplexion: Recipe["complexion"] = PALE;
  /** A pose as the hand has it now, while it moves; else null. */
  livePose: PoseRecipe | null = null;
  /** A source that is shown instead of the draft (an old revision), or null. */
  look: string | null = null;
  /** What is shown of layers that are tried, or alone. */
  readonly layerPreview = new LayerPreview(this);
  /** What the steps undone were, the next to redo last. */
  undone: readonly string[] = [];

  /** The points of the drag under way, or null. */
  #dragged: readonly number[] | null = null;
  #before: Float64Array = new Float64Array(0);
  #unanswered = 0;
  /** Steps on layers, or on a face's recipe, that the server has not answered. */
  readonly #steps = new RecipeSteps<Recipe | FaceRecipe | PoseRecipe>(() => this.draft?.recipe ?? null);

  constructor(private readonly send: Ask) {
    super();
  }

  // --- what is known --------------------------------------------------------------------------------------------------

  /** The open item. */
  get item(): ItemDocument | null {
    return this.items.find(({ id }) => id === this.draft?.item) ?? null;
  }

  /** The recipe under work as the hand has it, where it is an expression's. */
  get recipe(): Recipe | null {
    return this.draft?.recipe.kind === "expression" ? this.#steps.shown(this.draft.recipe) : null;
  }

  /** The recipe under work as the hand has it, where it is a face's. */
  get face(): FaceRecipe | null {
    return this.draft?.recipe.kind === "face" ? this.#steps.shown(this.draft.recipe) : null;
  }

  /** The recipe under work as the last step left it, where it is a pose's. */
  get pose(): PoseRecipe | null {
    return this.draft?.recipe.kind === "pose" ? this.#steps.shown(this.draft.recipe) : null;
  }

  /** The source of the expression that faces wear now: an old revision that is looked at, the draft, or neutral. */
  get shown(): string {
    if (this.look !== null) return this.look;
    return this.recipe === null ? "neutral" : (this.layerPreview.content ?? (this.draft as DraftState).content);
  }

  /** The recipe of what faces wear now, as far as it is known: null while an old revision is looked at. */
  get shownRecipe(): Recipe | null {
    return this.look !== null || this.recipe === null ? null : this.layerPreview.shown(this.recipe);
  }

  /** True from `begin` to `letGo` or `cancel`. */
  get dragging(): boolean {
    return this.#dragged !== null;
  }

  /** True while the live vectors are more than the server has answered. */
  get waiting(): boolean {
    return this.#unanswered > 0;
  }

  // --- what is shown --------------------------------------------------------------------------------------------------

  select(places: Iterable<number>): void {
    this.selection = new Set(places);
    this.tell("selection");
  }

  /** Shows a source instead of the draft; null: the draft again. */
  setLook(source: string | null): void {
    this.look = source;
    this.tell("draft");
  }

  // --- hands ----------------------------------------------------------------------------------------------------------

  /** A hand takes hold of points; it then writes `live` and says `liveChanged`. */
  begin(points: readonly number[]): void {
    this.#endSolo();
    this.#dragged = points;
    this.#before = this.live.slice();
  }

  liveChanged(): void {
    this.tell("live");
  }

  /** The hand lets go: the points are to lie at `targets`, metres, on the face under work. */
  letGo(points: readonly number[], targets: readonly Vector[]): void {
    this.#dragged = null;
    const face = this.sourceOf(this.work);
    this.edit({ type: "drag_points", face, points: [...points], targets: [...targets], vectors: split(this.live) });
  }

  /** The hand never meant it: all is where it was before `begin`. */
  cancel(): void {
    if (this.#dragged === null) return;
    this.#dragged = null;
    this.live = this.#before;
    this.tell("live");
  }

  /** All vectors at once, shown at once; `what` goes into the history. */
  setVectors(vectors: readonly Vector[], what: string): void {
    this.live = flat(vectors);
    this.tell("live");
    this.edit({ type: "set_vectors", vectors: [...vectors], what });
  }

  /** Other control points, rows of the sheet. */
  setNet(rows: readonly number[]): void {
    this.edit({ type: "set_net", net: [...rows] });
  }

  /** Other layers, made of those that the steps before leave. */
  setLayers(change: (layers: readonly Layer[]) => readonly Layer[]): void {
    this.#step<Recipe>(
      (recipe) => ({ ...recipe, layers: [...change(recipe.layers)] }),
      ({ layers }) => ({ type: "set_layers", layers }),
    );
  }

  /** A muscle pulls so much, on this page only, until `sendPulls`. */
  pull(muscle: string, contraction: number): void {
    this.livePulls = new Map(this.livePulls).set(muscle, contraction);
    this.tell("live");
  }

  sendPulls(): void {
    const pulls = [...this.livePulls].filter(([, contraction]) => contraction !== 0);
    this.edit({ type: "set_pulls", pulls: pulls.map(([muscle, contraction]) => ({ muscle, contraction })) });
  }

  /** Eyes turn so far, on this page only, until `sendEyes`. */
  turnEyes(turns: Recipe["eyes"], pupil: number): void {
    this.liveEyes = { turns, pupil };
    this.tell("live");
  }

  sendEyes(): void {
    this.edit({ type: "set_eyes", eyes: this.liveEyes.turns, pupil: this.liveEyes.pupil });
  }

  /** Blood, tears and sweat show so far, on this page only, until `sendComplexion`. */
  flush(complexion: Recipe["complexion"]): void {
    this.liveComplexion = complexion;
    this.tell("live");
  }

  sendComplexion(): void {
    this.edit({ type: "set_complexion", complexion: this.liveComplexion });
  }

  /** Another recipe of a face, made of the one that the steps before leave; `what` goes into the history. */
  setFace(change: (recipe: FaceRecipe) => FaceRecipe, what: string): void {
    this.#endSolo();
    this.#step<FaceRecipe>(change, (recipe) => ({ type: "set_face", recipe, what }));
  }

  /** A pose is shown so, on this page only, until `setPose`; null: as the last step left it. */
  showPose(recipe: PoseRecipe | null): void {
    this.livePose = recipe;
    this.tell("live");
  }

  /** Another recipe of a pose; `what` goes into the history. */
  setPose(pose: PoseRecipe, what: string): void {
    this.livePose = null;
    this.#step<PoseRecipe>(
      () => pose,
      (recipe) => ({ type: "set_pose", recipe, what }),
    );
  }

  /** A step that is made of the recipe: it waits for the steps before it, and is shown at once. */
  #step<Kind extends Recipe | FaceRecipe | PoseRecipe>(
    change: (recipe: Kind) => Kind,
    asked: (recipe: Kind) => ItemChange,
  ): void {
    if (this.draft === null) return;
    if (this.look !== null) this.setLook(null);
    const { item } = this.draft;
    this.#steps.add(change as (recipe: Recipe | FaceRecipe | PoseRecipe) => Kind, (recipe, answered) =>
      this.#askNow({ ...asked(recipe as Kind), item } as Request, answered),
    );
    this.tell("draft");
  }

  // --- requests -------------------------------------------------------------------------------------------------------

  /** Asks, takes the answer in, and says what is refused; null where it was. */
  async ask(request: Request): Promise<EditorAnswer | null> {
    if (this.#steps.size > 0) await this.#steps.empty(); // a save or an undo is of all that was done before it
    return this.#askNow(request, () => undefined);
  }

  async #askNow(request: Request, answered: () => void): Promise<EditorAnswer | null> {
    this.#unanswered += 1;
    const turn = this.noteAsked(request.type);
    try {
      const answer = await this.send(request);
      this.#unanswered -= 1;
      answered();
      const { draft } = this;
      if (answer.type !== "draft" || answer.item === draft?.item || this.isNewest(turn)) this.receive(answer);
      if (answer.type !== "draft") this.#takeAnswer();
      return answer;
    } catch (error) {
      this.#unanswered -= 1;
      answered();
      this.say(error instanceof Error ? error.message : String(error));
      this.#takeAnswer(); // what was refused goes from sight
      this.tell("draft");
      return null;
    }
  }

  /** A change of the open item; an old revision that was looked at goes, for who edits wants to see it. */
  edit(change: ItemChange): void {
    this.#endSolo();
    if (this.draft === null) return;
    if (this.look !== null) this.setLook(null);
    void this.ask({ ...change, item: this.draft.item } as Request);
  }

  /** An answer, or what the server says by itself. */
  receive(message: ToEditor): void {
    if (message.type === "draft") this.#receiveDraft(message);
    else if (message.type === "items") this.setItems(message.items, message.digest);
    else if (message.type === "greeted") this.setHeadControls(message);
    else if (message.type === "history") this.#receiveHistory(message.item, message.revisions);
    else if (message.type === "refused") this.say(message.reason);
  }

  /** Nothing is open any more. */
  override leave(): void {
    [this.draft, this.net, this.live, this.livePulls] = [null, null, new Float64Array(0), new Map()];
    this.#forget();
    this.tell("draft");
  }

  /** Hands work on all of the draft: they must see all of it. */
  #endSolo(): void {
    if (this.layerPreview.solo.size > 0 && this.layerPreview.end()) this.tell("draft");
  }

  #receiveHistory(item: number, revisions: readonly RevisionDocument[]): void {
    if (item !== this.draft?.item) return;
    this.revisions = revisions;
    this.tell("history");
  }

  #receiveDraft(draft: DraftState): void {
    const left = this.draft?.item ?? draft.item;
    const other = draft.item !== this.draft?.item;
    if (left !== draft.item) this.send({ type: "close_item", item: left }).catch(() => undefined); // nobody waits for it
    const before = this.net;
    if (draft.net !== null) this.net = readNet(draft.net);
    else if (draft.recipe.kind !== "expression") this.net = null;
    this.draft = draft;
    if (other) this.#forget();
    else if (this.net !== before) this.select(keptPlaces(this.selection, before, this.net));
    this.setUnsaved(draft.item, draft.dirty);
    this.layerPreview.renew();
    this.#takeAnswer();
    this.tell("draft");
  }

  /** Another item is open: what belonged to the one before goes. */
  #forget(): void {
    this.layerPreview.end();
    this.#steps.forget();
    this.livePose = null;
    [this.#dragged, this.look, this.revisions, this.undone] = [null, null, [], []];
    this.select([]);
    this.tell("history");
  }

  /** What the hand shows becomes what the server has, unless an answer is still to come; a drag under way goes on. */
  #takeAnswer(): void {
    const recipe = this.recipe;
    if (recipe === null || this.#unanswered > 0) return;
    const vectors = flat(recipe.vectors);
    if (this.#dragged !== null && vectors.length === this.live.length) {
      const before = this.#before;
      this.live = this.live.map((value, at) => (vectors[at] as number) + (value - (before[at] as number)));
      this.#before = vectors;
    } else {
      this.#dragged = null;
      this.live = vectors;
    }
    this.liveEyes = { turns: recipe.eyes, pupil: recipe.pupil };
    this.liveComplexion = recipe.complexion;
    this.livePulls = new Map(recipe.pulls.map(({ muscle, contraction }) => [muscle, contraction]));
    this.tell("live");
  }
}
