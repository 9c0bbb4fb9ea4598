/** The scene of the face editor: the face under work, once large and at rest, and again with other expressions beside it. */

import type { Anatomy } from "../../../face/anatomy/anatomy";
import type { RibbonStyle } from "../../../face/hair/hair_geometry";
import type { FaceRecipe, HandlesAsset } from "../../../link/editing_messages";
import type { FaceDocument, Manifest } from "../../../link/messages";
import { loadFace, loadWorn } from "../../session/asset_loading";
import { type Handles, handlesOf, loadHandles } from "../../session/face_handles";
import type { DrawnFace, DrawnFaces, ShownFace } from "../draw/drawn_face";
import { boundsOf } from "../math/camera";
import { ChangedRows } from "../model/changed_rows";
import { type Difference, Figure, farthest, lengths } from "../model/figure";
import { type HandleDeform, handleDeform } from "../model/handle_deform";

/** What the face wears, the first at rest: the sum of expressions, and what people read. */
const WORN: readonly { label: string; expressions: readonly string[] }[] = [
  { label: "At rest", expressions: [] },
  { label: "Smile", expressions: ["smile"] },
  { label: "Blink", expressions: ["eyeBlinkLeft", "eyeBlinkRight"] },
  { label: "Jaw open", expressions: ["jawOpen"] },
];

/** One picture of the face, as the canvas draws any face. */
export interface FacePicture extends ShownFace {
  drawn: DrawnFace;
  /** What it wears, for people. */
  label: string;
  /** What the server made, (rows, 3) metres. */
  truth: Float32Array;
}

/** A face under work as the server has it: its item, what it is made of, and where that is kept. */
interface DraftFace {
  item: number;
  content: string;
  recipe: FaceRecipe;
}

/** A face as the server made it, with all it wears. */
interface Arrival {
  content: string;
  item: number;
  document: FaceDocument;
  style: RibbonStyle | undefined;
  shape: HandleDeform;
  under: string;
  handles: Handles;
  truths: Float32Array[];
}

export class FaceScene {
  /** The pictures, in the order of WORN; empty until the first face is here. */
  all: FacePicture[] = [];
  handles: Handles | undefined;
  /** How far the pictures were from what the server made, when that came last, by label. */
  readonly differences = new Map<string, Difference>();
  private item = -1;
  /** The item that was asked for last; -1: none, or it cannot be had. */
  private awaited = -1;
  /** What is mixed in the pictures, in the content that was asked for last, and by the hand. */
  private mixes = { shown: "", made: "", asked: "" };
  private content = "";
  private shape: HandleDeform | undefined;
  /** What lies under the handles of this shape. */
  private under = "";
  /** The face at rest as the shape has it where the server made it: where handles were pulled very far, it may miss. */
  private servedRest: Float32Array = new Float32Array();
  private moves: Float64Array = new Float64Array();
  private asset: Promise<HandlesAsset> | undefined;
  private arrival: Arrival | undefined;
  private changed = false;
  private readonly everything: ChangedRows["all"];
  private readonly rows: { skin: number; balls: Uint32Array[] };

  constructor(
    private readonly faces: DrawnFaces,
    anatomy: Anatomy,
    skin: number,
  ) {
    this.everything = new ChangedRows(anatomy.fans).all;
    const ball = (n: number): Uint32Array => {
      const [first, end] = [anatomy.eyeRows[2 * n] as number, anatomy.eyeRows[2 * n + 1] as number];
      return Uint32Array.from({ length: end - first }, (_, at) => first + at);
    };
    this.rows = { skin, balls: [ball(0), ball(1)].filter((rows) => rows.length > 0) };
  }

  /** Shows a draft as the server made it, its content, by its recipe; what is there stays until all of it has come.
   * hand: the recipe as the hand has it, with steps that are not answered. */
  async show(manifest: Manifest, draft: DraftFace, hand: FaceRecipe): Promise<void> {
    const { item, content } = draft;
    [this.mixes.made, this.mixes.asked] = [mixOf(item, draft.recipe), mixOf(item, hand)];
    if (content === this.content && item === this.item) {
      if (this.all[0]?.source === content) this.mixes.shown = this.mixes.made; // it looks the same
      return;
    }
    [this.content, this.awaited] = [content, item];
    try {
      await this.fetch(manifest, item, content, hand);
    } catch (error) {
      if (content === this.content) [this.awaited, this.mixes.asked] = [-1, this.mixes.shown];
      throw error;
    }
  }

  private async fetch(manifest: Manifest, item: number, content: string, recipe: FaceRecipe): Promise<void> {
    this.asset ??= loadHandles();
    const [{ document, positions }, asset] = await Promise.all([loadFace(manifest, content), this.asset]);
    const wear = async (expressions: readonly string[]): Promise<Float32Array> => {
      const existing = expressions.filter((name) =>
        manifest.expressions.some((expression) => expression.name === name),
      );
      const worn = await Promise.all(existing.map((name) => loadWorn(manifest, content, name, positions)));
      return positions.map((rest, at) => worn.reduce((sum, wornShape) => sum + (wornShape[at] as number) - rest, rest));
    };
    const [style, ...truths] = await Promise.all([
      this.faces.wardrobe(document, positions),
      ...WORN.map(({ expressions }) => wear(expressions)),
    ]);
    if (content !== this.content) return; // something newer is on its way
    const handles = handlesOf(asset, recipe);
    const under = JSON.stringify([item, recipe.base, recipe.regions, recipe.amount, handles.rows]);
    // Where only handles were moved, the face at rest is known already, and exactly.
    const sameShape = under === this.under ? this.shape : undefined;
    sameShape?.hold(handles.moves);
    const shape = sameShape ?? handleDeform(positions, this.rows, handles.rows, handles.moves);
    this.arrival = { content, item, document, style, shape, under, handles, truths };
  }

  /** Whether the item that was asked for last is still to come, while nothing or another one is shown. */
  get awaits(): boolean {
    return this.awaited >= 0 && (this.all.length === 0 || this.item !== this.awaited);
  }

  /** Whether another mix than the hand's is shown: the server makes it, or it is on its way. */
  get makes(): boolean {
    return this.all.length > 0 && this.mixes.asked !== this.mixes.shown;
  }

  /** Whether all pictures show what was asked for last, and nothing eases. */
  settled(time: number): boolean {
    const shown = this.all.length > 0 && this.all[0]?.source === this.content;
    return shown && this.arrival === undefined && this.all.every(({ figure }) => figure.lag(time) === 0);
  }

  /** Moves the handles, (n, 3) metres: all pictures follow. */
  move(moves: Float64Array): void {
    this.moves = moves;
    this.changed = true;
  }

  /** Forgets what is shown: the canvas is needed for something else. */
  leave(): void {
    for (const { drawn } of this.all) this.faces.give(drawn);
    [this.all, this.content, this.item, this.handles, this.under] = [[], "", -1, undefined, ""];
    [this.awaited, this.mixes] = [-1, { shown: "", made: "", asked: "" }];
    [this.shape, this.arrival] = [undefined, undefined];
  }

  /** Takes a picture to the front: it is then drawn large, the others beside it. */
  front(n: number): void {
    const [first, chosen] = [this.all[0], this.all[n]];
    if (first === undefined || chosen === undefined) return;
    this.all = [chosen, ...this.all.filter((picture) => picture !== chosen)];
  }

  /** Brings the pictures up to a time (seconds); whether anything moved. `ahead`: a hand shows more than was answered. */
  advance(time: number, ahead: boolean): boolean {
    const easing = this.all.some(({ figure }) => Number.isFinite(figure.easedFrom));
    if (!this.changed && !easing && this.arrival === undefined) return false;
    if (this.arrival !== undefined) this.take(this.arrival, time, ahead);
    else if (this.changed) this.pose();
    this.changed = false;
    for (const { drawn, figure } of this.all) {
      const lag = figure.lag(time);
      if (lag === 0) figure.easedFrom = -Infinity;
      drawn.put(figure, lag, this.everything);
    }
    return true;
  }

  private take(arrival: Arrival, time: number, ahead: boolean): void {
    const { content, item, document, style, shape, under, handles, truths } = arrival;
    this.arrival = undefined;
    this.mixes.shown = this.mixes.made;
    const fresh = item !== this.item || this.all.length === 0;
    if (fresh) this.begin(document, truths);
    const shown = this.all.map(({ figure }) => figure.base.slice());
    if (!ahead || fresh) this.moves = handles.moves;
    [this.item, this.shape, this.under, this.handles] = [item, shape, under, handles];
    this.servedRest = shape.at(handles.moves).slice();
    for (const picture of this.all) {
      picture.drawn.dress(document, style);
      picture.rest = truths[0] as Float32Array;
      picture.truth = truths[WORN.findIndex(({ label }) => label === picture.label)] as Float32Array;
      [picture.source, picture.document] = [content, { ...document, label: picture.label }];
    }
    this.pose();
    this.all.forEach((picture, n) => {
      ease(picture, fresh ? picture.figure.base : (shown[n] as Float32Array), fresh ? -Infinity : time);
      const { offset, rest } = picture.figure;
      this.differences.set(picture.label, { ...lengths(offset), move: farthest(rest, picture.truth) });
    });
  }

  private begin(document: FaceDocument, truths: readonly Float32Array[]): void {
    const bounds = boundsOf(truths[0] as Float32Array); // kept while the face is under work: the view stays
    for (const { drawn } of this.all) this.faces.give(drawn);
    this.all = WORN.map(({ label }, n) => {
      const truth = truths[n] as Float32Array;
      return {
        source: "",
        document,
        figure: new Figure(label, truth, undefined),
        rest: truths[0] as Float32Array,
        bounds,
        drawn: this.faces.take(),
        label,
        truth,
      };
    });
  }

  /** Puts every picture where the handles lead: what moves the face at rest moves it with any expression. */
  private pose(): void {
    const { shape, servedRest, moves } = this;
    if (shape === undefined) return;
    const there = shape.at(moves);
    for (const { figure, truth } of this.all) {
      for (let at = 0; at < truth.length; at++)
        figure.base[at] = (truth[at] as number) + (there[at] as number) - (servedRest[at] as number);
      figure.live.set(figure.base);
    }
  }
}

/** Faces of one mix have the same, whatever their handles and gains. */
const mixOf = (item: number, { base, regions, amount }: FaceRecipe): string =>
  JSON.stringify([item, base, regions, amount]);

/** The picture goes from what was shown to what is there now, from a time on. */
function ease({ figure }: FacePicture, shown: Float32Array, time: number): void {
  figure.offset.forEach((_, at) => {
    figure.offset[at] = (shown[at] as number) - (figure.base[at] as number);
  });
  figure.easedFrom = time;
}
