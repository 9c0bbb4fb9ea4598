/** The faces of the canvas with all that they wear: what the server computed, and what the hand adds to it. */

import type { Anatomy } from "../../../face/anatomy/anatomy";
import type { Library } from "../../../link/assets";
import type { Manifest } from "../../../link/messages";
import { loadFace, loadTangents, loadWorn } from "../../session/asset_loading";
import type { Followers, Muscle, Net } from "../../session/control_net";
import type { DrawnFaces, ShownFace } from "../draw/drawn_face";
import { boundsOf } from "../math/camera";
import { ChangedRows } from "../model/changed_rows";
import { type Difference, Figure } from "../model/figure";
import { addField, type Moves, type Reach, reachOf } from "../model/influence_field";
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

/** Faces that are shown at most: the work, and ten beside it. */
const MOST = 11;
/** Faces that take what has come for them in one frame, at most: more would make the frame late. */
const ARRIVALS = 3;

interface Arrival {
  member: ShownFace;
  wanted: WornExpression;
  base: Float32Array;
}

export class ExpressionScene {
  /** The last differences between linearised and true shape, by face. */
  readonly differences = new Map<string, Difference>();
  /** How often faces have taken a true shape. */
  arrived = 0;
  private readonly members = new Map<string, ShownFace>();
  private readonly asked = new Map<string, Promise<ShownFace>>();
  private readonly changedRows: ChangedRows;
  /** What the hand adds, by what it adds to. */
  private readonly fields = new Map<Moves, Float32Array>();
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
    private readonly library: Library,
    { fans }: Anatomy,
    private readonly faces: DrawnFaces,
  ) {
    this.changedRows = new ChangedRows(fans);
  }

  setFollowers(followers: Followers | null): void {
    if (followers === null || followers === this.followers) return;
    this.followers = followers;
    this.changedRows.setFollowers(followers);
  }

  /** The member of a source, once it is here. */
  member(source: string): ShownFace | undefined {
    return this.members.get(source);
  }

  /** Shows these faces, by source; resolves when all are here. */
  async show(manifest: Manifest, sources: readonly string[]): Promise<void> {
    this.shown = [...new Set(sources)].slice(0, MOST);
    for (const member of this.members.values()) {
      if (member.drawn === undefined || this.shown.includes(member.source)) continue;
      this.faces.give(member.drawn);
      member.drawn = undefined;
    }
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
    this.writeFields();
    this.put(time);
    return whole ? "whole" : "part";
  }

  /** Where the rows are that changed in the last step, on a face. */
  spread({ figure }: ShownFace): Spread {
    return spreadOf(figure, this.turned);
  }

  private onStage(): ShownFace[] {
    return [...this.members.values()].filter(({ drawn }) => drawn !== undefined);
  }

  private async call(manifest: Manifest, source: string): Promise<void> {
    const asked = this.asked.get(source) ?? this.load(manifest, source);
    this.asked.set(source, asked);
    asked.catch(() => this.asked.delete(source));
    const member = await asked;
    const style = await this.faces.wardrobe(member.document, member.rest);
    if (!this.shown.includes(source) || member.drawn !== undefined) return;
    member.drawn = this.faces.take();
    member.drawn.dress(member.document, style);
    this.fresh.add(member);
    this.changed = true;
    await this.fit(manifest, member);
  }

  private async load(manifest: Manifest, source: string): Promise<ShownFace> {
    const [face, tangents] = await Promise.all([loadFace(manifest, source), loadTangents(manifest, source)]);
    const { document, positions: rest } = face;
    const figure = new Figure(document.name, rest, tangents);
    const member = { source, document, figure, rest, bounds: boundsOf(rest), drawn: undefined };
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
      this.fresh.add(member);
    }
  }

  /** The field of what the hand adds to what a face wears; undefined: nothing. */
  private fieldOf({ moves, net }: WornExpression): Float32Array | undefined {
    const { hand, library } = this;
    if (moves === undefined || hand.moves === undefined || net === null || net !== hand.net) return undefined;
    if (this.reach?.net !== net) this.reach = { net, of: reachOf(net) };
    const field = new Float32Array(4 * library.manifest.skin);
    return addField(field, this.reach.of, hand.muscles, hand.moves, moves) ? field : undefined;
  }

  /** A field for each of the different things that faces wear. */
  private writeFields(): void {
    this.fields.clear();
    for (const { figure } of this.onStage()) {
      const { moves } = figure.worn;
      if (moves === undefined || this.fields.has(moves)) continue;
      const field = this.fieldOf(figure.worn);
      if (field !== undefined) this.fields.set(moves, field);
    }
  }

  private fieldUnder({ worn: { moves } }: Figure): Float32Array | undefined {
    return moves && this.fields.get(moves);
  }

  /** Puts all faces where they are at a time: of those that have just come all rows, of others what changes. */
  private put(time: number): void {
    const easing = this.onStage().filter(({ figure }) => Number.isFinite(figure.easedFrom));
    const offsets = easing.map(({ figure }) => figure.offset);
    const rows = this.changedRows.after([...this.fields.values()], offsets);
    this.turned = rows.turned;
    for (const member of this.onStage()) {
      const { figure, drawn } = member;
      const lag = figure.lag(time);
      if (lag === 0) figure.easedFrom = -Infinity;
      figure.move(this.fieldUnder(figure), this.followers);
      drawn?.put(figure, lag, this.fresh.has(member) ? this.changedRows.all : rows);
    }
    this.fresh.clear();
  }
}
