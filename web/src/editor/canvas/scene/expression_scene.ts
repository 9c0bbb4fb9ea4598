/** The faces of the canvas with all that they wear: what the server computed, and what the hand adds to it. */

import type { Anatomy } from "../../../face/anatomy/anatomy";
import type { Library } from "../../../link/assets";
import type { Manifest } from "../../../link/messages";
import { loadFace, loadTangents, loadWorn } from "../../session/asset_loading";
import type { Followers, Muscle, Net } from "../../session/control_net";
import { MOST_BLOCKS } from "../draw/atlas_shaders";
import { FaceAtlas } from "../draw/face_atlas";
import type { SkinTextures } from "../draw/skin_texture";
import { boundsOf } from "../math/camera";
import { ChangedRows } from "../model/changed_rows";
import { type Difference, Figure } from "../model/figure";
import { addField, type Moves, type Reach, reachOf } from "../model/influence_field";
import type { ShownFace } from "../model/shown_face";
import { type Spread, spreadOf } from "../model/spread";

/** What all faces wear: an expression's source, and what of it hand and muscles made. */
export interface WornExpression {
  source: string;
  moves: Moves | undefined;
  net: Net | null;
}

/** What the hand shows now. */
export interface Hand {
  net: Net | null;
  moves: Moves | undefined;
  muscles: readonly Muscle[];
}

/** Faces that take what has come for them in one frame, at most: more would make the frame late. */
const ARRIVALS = 3;

interface Arrival {
  member: ShownFace;
  wanted: WornExpression;
  base: Float32Array;
}

export class ExpressionScene {
  readonly faceAtlas: FaceAtlas;
  /** The last differences between linearised and true shape, by face. */
  readonly differences = new Map<string, Difference>();
  /** How often faces have taken a true shape. */
  arrived = 0;
  private readonly members = new Map<string, ShownFace>();
  private readonly asked = new Map<string, Promise<ShownFace>>();
  private readonly changedRows: ChangedRows;
  private readonly fields: Float32Array[];
  private readonly slots = new Int32Array(MOST_BLOCKS).fill(-1);
  private readonly lags = new Float32Array(MOST_BLOCKS);
  private readonly arrivals: Arrival[] = [];
  private readonly fresh = new Set<ShownFace>();
  private shown: string[] = [];
  private wanted: WornExpression = { source: "neutral", moves: undefined, net: null };
  private reach: { net: Net; of: Reach } | undefined;
  private followers: Followers | null = null;
  private hand: Hand = { net: null, moves: undefined, muscles: [] };
  private changed = true;
  private turned: Uint32Array = new Uint32Array();

  constructor(
    gl: WebGL2RenderingContext,
    readonly library: Library,
    readonly anatomy: Anatomy,
    private readonly skinTextures: SkinTextures,
    private readonly side: number,
  ) {
    const { vertices, skin } = library.manifest;
    this.faceAtlas = new FaceAtlas(gl, vertices, anatomy.fans);
    this.changedRows = new ChangedRows(anatomy.fans);
    this.fields = Array.from({ length: MOST_BLOCKS }, () => new Float32Array(4 * skin));
  }

  setFollowers(followers: Followers | null): void {
    if (followers === null || followers === this.followers) return;
    this.followers = followers;
    this.faceAtlas.setFollowers(followers);
    this.changedRows.setFollowers(followers);
  }

  /** The member of a source, once it is here. */
  member(source: string): ShownFace | undefined {
    return this.members.get(source);
  }

  /** Shows these faces, by source; resolves when all are here. */
  async show(manifest: Manifest, sources: readonly string[]): Promise<void> {
    this.shown = [...new Set(sources)].slice(0, MOST_BLOCKS - 1);
    for (const member of this.members.values()) if (!this.shown.includes(member.source)) member.block = -1;
    await Promise.all(this.shown.map((source) => this.call(manifest, source)));
  }

  /** What all faces are to wear; each puts it on when the server has it. */
  dress(manifest: Manifest, wanted: WornExpression): void {
    this.wanted = wanted;
    for (const member of this.onStage()) this.fit(manifest, member).catch((error: unknown) => console.warn(error)); // it keeps what it wears
    this.changed = true;
  }

  /** What the hand shows now. */
  follow(hand: Hand): void {
    this.hand = hand;
    this.changed = true;
  }

  /** Where a face will be once nothing eases, (rows, 3) metres. */
  positions({ figure }: ShownFace): Float32Array {
    figure.move(this.fieldOf(figure.worn), this.followers);
    return figure.live;
  }

  /** Whether every shown face wears what it is to wear, and nothing eases. */
  settled(time: number): boolean {
    return (
      this.shown.every((source) => this.members.get(source)?.figure.worn.source === this.wanted.source) &&
      this.arrivals.length === 0 &&
      this.onStage().every(({ figure }) => figure.lag(time) === 0)
    );
  }

  /** Brings the picture up to a time (seconds): what of it changed, `part`: only rows that the hand leads (`spread`). */
  advance(time: number): "nothing" | "part" | "whole" {
    const easing = this.onStage().some(({ figure }) => Number.isFinite(figure.easedFrom));
    if (!this.changed && !easing && this.arrivals.length === 0) return "nothing";
    const whole = easing || this.arrivals.length > 0 || this.fresh.size > 0;
    this.changed = false;
    this.takeArrivals(time);
    const used = this.assignFields();
    for (const field of used.values()) this.faceAtlas.setField(field.slot, field.values);
    const work = this.members.get(this.shown[0] ?? "");
    if (work !== undefined) this.moveFigure(work, used);
    this.passes(used, time);
    return whole ? "whole" : "part";
  }

  /** Where the rows are that changed in the last step, on a face. */
  spread({ figure, block }: ShownFace): Spread {
    const slot = this.slots[block] as number;
    return spreadOf(figure, this.turned, slot < 0 ? undefined : this.fields[slot]);
  }

  dispose(): void {
    this.faceAtlas.dispose();
  }

  /** Members that have a block, in the order of the blocks. */
  private onStage(): ShownFace[] {
    return [...this.members.values()].filter(({ block }) => block >= 0);
  }

  private async call(manifest: Manifest, source: string): Promise<void> {
    const asked = this.asked.get(source) ?? this.load(manifest, source);
    this.asked.set(source, asked);
    asked.catch(() => this.asked.delete(source));
    const member = await asked;
    if (!this.shown.includes(source) || member.block >= 0) return;
    const taken = new Set(this.onStage().map(({ block }) => block));
    member.block = Array.from({ length: MOST_BLOCKS }, (_, block) => block).find(
      (block) => !taken.has(block),
    ) as number;
    this.faceAtlas.upload(member.block, member.figure, true);
    this.fresh.add(member);
    this.changed = true;
    await this.fit(manifest, member);
  }

  private async load(manifest: Manifest, source: string): Promise<ShownFace> {
    const [face, tangents] = await Promise.all([loadFace(manifest, source), loadTangents(manifest, source)]);
    const { document, positions } = face;
    const figure = new Figure(document.name, positions, tangents);
    const picture = await this.skinTextures.picture(document);
    const skinTexture = this.skinTextures.paint(document.look, picture, this.side);
    const bounds = boundsOf(positions);
    const member = { source, document, figure, rest: positions, bounds, skinTexture, block: -1 };
    this.members.set(source, member);
    return member;
  }

  private async fit(manifest: Manifest, member: ShownFace): Promise<void> {
    const { wanted } = this;
    if (member.figure.worn.source === wanted.source) {
      member.figure.worn = { ...wanted }; // the same shape, made of other moves
      return;
    }
    const base = await loadWorn(manifest, member.source, wanted.source, member.figure.rest);
    if (this.wanted !== wanted) return; // something newer is on its way
    this.arrivals.push({ member, wanted, base });
  }

  private takeArrivals(time: number): void {
    for (const { member, wanted, base } of this.arrivals.splice(0, ARRIVALS)) {
      if (wanted !== this.wanted) continue;
      const { figure } = member;
      figure.move(this.fieldOf(figure.worn), this.followers);
      const first = figure.worn.source === "neutral" && this.fresh.has(member);
      const difference = figure.wear({ ...wanted }, base, this.fieldOf(wanted), this.followers, time);
      if (first) figure.easedFrom = -Infinity; // nobody has seen it yet
      if (first) figure.offset.fill(0);
      this.differences.set(figure.name, difference);
      this.arrived += 1;
      if (member.block < 0) continue;
      this.faceAtlas.upload(member.block, figure, false);
      this.fresh.add(member);
    }
  }

  /** The field of what the hand adds to what a face wears; undefined: nothing. */
  private fieldOf(worn: WornExpression): Float32Array | undefined {
    const field = new Float32Array(this.fields[0]?.length ?? 0);
    return this.writeField(field, worn) ? field : undefined;
  }

  private writeField(field: Float32Array, { moves, net }: WornExpression): boolean {
    const { hand } = this;
    field.fill(0);
    if (moves === undefined || hand.moves === undefined || net === null || net !== hand.net) return false;
    if (this.reach?.net !== net) this.reach = { net, of: reachOf(net) };
    return addField(field, this.reach.of, hand.muscles, hand.moves, moves);
  }

  /** A slot for each of the different things that faces wear. */
  private assignFields(): Map<Moves, { slot: number; values: Float32Array }> {
    const used = new Map<Moves, { slot: number; values: Float32Array }>();
    this.slots.fill(-1);
    for (const { block, figure } of this.onStage()) {
      const { moves } = figure.worn;
      if (moves === undefined) continue;
      if (!used.has(moves)) {
        const values = this.fields[used.size] as Float32Array;
        if (!this.writeField(values, figure.worn)) continue;
        used.set(moves, { slot: used.size, values });
      }
      this.slots[block] = used.get(moves)?.slot ?? -1;
    }
    return used;
  }

  private moveFigure({ figure }: ShownFace, used: ReadonlyMap<Moves, { values: Float32Array }>): void {
    const field = figure.worn.moves === undefined ? undefined : used.get(figure.worn.moves)?.values;
    figure.move(field, this.followers);
  }

  private passes(used: ReadonlyMap<Moves, { values: Float32Array }>, time: number): void {
    const staged = this.onStage();
    const offsets: Float32Array[] = [];
    for (const { block, figure } of staged) {
      const lag = figure.lag(time);
      this.lags[block] = lag;
      if (Number.isFinite(figure.easedFrom)) offsets.push(figure.offset);
      if (lag === 0) figure.easedFrom = -Infinity;
    }
    const lists = this.changedRows.after(
      [...used.values()].map(({ values }) => values),
      offsets,
    );
    this.turned = lists.turned;
    const step = { ...lists, slots: this.slots, lags: this.lags };
    const count = staged.reduce((most, { block }) => Math.max(most, block + 1), 0);
    this.faceAtlas.run(step, 0, count);
    for (const { block } of this.fresh)
      if (block >= 0) this.faceAtlas.run({ ...step, ...this.changedRows.all }, block, 1);
    this.fresh.clear();
  }
}
