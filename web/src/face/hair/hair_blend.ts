/** Blends hair styles: each strand takes the course of all styles on air at its root, as long as the faces there have hair. */

import { MathUtils } from "three";
import type { HairStrands } from "../../link/strands";
import { lengthAt, strandLength, WHOLE_HAIR } from "./hair_strands";
import { moveOutward, type RadialMap, radiusOf, radiusUnder } from "./radial_map";
import { type Matches, matchRoots, woundStrands } from "./root_matching";

/** Of the weight of the heaviest style: where another begins to be drawn beside it, as the same hair by then. */
const BESIDE = 0.6;

/** How much later hair comes where the scalp is not painted, at the hairline too: short hair lies on bare skin like chips. */
const LATER = 2;

/** A style as the faces on air carry it. */
export interface CarriedStyle {
  readonly hair: HairStrands;
  /** Metres from the skin at each strand's root, mixed over all faces on air; four numbers a place. */
  readonly carried: Float32Array;
  /** How dark the scalp under it is painted, 0..1, mixed over its wearers. */
  readonly scalp: number;
}

/** What does not change about a style. */
interface Study {
  /** 1 for each strand that is wound up. */
  readonly wound: Uint8Array;
  /** Metres of each place over the generic scalp. */
  readonly heights: Float32Array;
  /** Metres along each strand. */
  readonly lengths: Float32Array;
  /** How far each strand's root stands on painted scalp, 0..1. */
  readonly rooted: Float32Array;
}

/** A style as a source of the courses of another's strands. */
interface StrandSource extends Matches {
  readonly from: CarriedStyle;
  readonly heights: Float32Array;
  readonly lengths: Float32Array;
  readonly weight: number;
  /** How much of it is drawn by itself, 0..1. */
  readonly drawn: number;
  /** Of the strand that is being shaped: its share, and its first place in the source. */
  share: number;
  first: number;
}

/** Blends styles on one head. */
export class HairBlend {
  private readonly studies = new Map<HairStrands, Study>();
  private readonly matches = new Map<HairStrands, Map<HairStrands, Matches>>();
  private places = new Float64Array();

  /** `scalp`: the generic head, over which all styles were grown; `painted`: the rows of its skin under hair, 0..1 each. */
  constructor(
    private readonly scalp: () => RadialMap,
    private readonly painted: (row: number) => number,
  ) {}

  /**
   * Writes the first `count` strands of a style as all styles on air together shape them: metres from the skin at each root;
   * beside the first three places how much of its length there is (0..1), how much of its width (0..1), and its whole length.
   * Returns how much shows of the strand that shows most, 0..1.
   */
  write(style: CarriedStyle, weights: ReadonlyMap<CarriedStyle, number>, into: Float32Array, count: number): number {
    const sources = this.sources(style, weights);
    const { wound, rooted } = this.study(style.hair);
    const bald = Math.max(0, 1 - sources.reduce((sum, source) => sum + source.weight, 0));
    let most = 0;
    for (let strand = 0; strand < count; strand++) {
      const weight = choose(sources, strand, style.hair.stations);
      const bare = 1 - style.scalp * (rooted[strand] as number);
      const length = lengthAt(
        weight - LATER * bare * Math.max(0, WHOLE_HAIR - weight),
        Math.min(1, bald / Math.max(1 - weight, 1e-6)),
      );
      const width = length > 0 ? widthOf(style, sources, strand) : 0;
      const at = 4 * strand * style.hair.stations;
      if (width > 0) this.shape(style, strand, sources, into);
      if (wound[strand] === 1) shrink(into, at, at + 4 * style.hair.stations, length);
      into[at + 3] = wound[strand] === 1 ? 1 : length;
      into[at + 7] = width;
      into[at + 11] = wholeLength(sources, strand);
      most = Math.max(most, Math.min(length, width));
    }
    return most;
  }

  private sources(style: CarriedStyle, weights: ReadonlyMap<CarriedStyle, number>): StrandSource[] {
    const heaviest = Math.max(...weights.values());
    return [...weights].map(([from, weight]) => {
      const { heights, lengths } = this.study(from.hair);
      const drawn = MathUtils.smoothstep(weight / heaviest, BESIDE, 1);
      return { ...this.matched(style, from), from, heights, lengths, weight, drawn, share: 0, first: 0 };
    });
  }

  /** A strand's places: the mean of its courses, each from its own root. */
  private shape(style: CarriedStyle, strand: number, sources: readonly StrandSource[], into: Float32Array): void {
    const { stations } = style.hair;
    const own = strand * stations;
    const mean = this.room(stations);
    fillPlaces(mean, style.carried, 4 * own, stations);
    let alone = true;
    for (const { from, first, share } of sources) {
      if (share === 0) continue;
      alone &&= share === 1;
      addCourse(mean, from.carried, 4, first, share, stations);
    }
    for (let place = 0; place < stations; place++)
      for (let axis = 0; axis < 3; axis++) into[4 * (own + place) + axis] = mean[4 * place + axis] as number;
    if (!alone) this.lift(style, own, sources, into);
  }

  /**
   * Between two courses around the head the straight mean runs through the skull: it is moved out to where it lies as
   * high over the scalp as the courses do, on the generic head; faces carry it as they carry the courses.
   */
  private lift(style: CarriedStyle, own: number, sources: readonly StrandSource[], into: Float32Array): void {
    const { points, stations } = style.hair;
    const [mean, scalp] = [this.room(stations), this.scalp()];
    fillPlaces(mean, points, 3 * own, stations);
    for (const { from, heights, first, share } of sources) {
      if (share === 0) continue;
      addCourse(mean, from.hair.points, 3, first, share, stations);
      for (let place = 0; place < stations; place++)
        mean[4 * place + 3] = (mean[4 * place + 3] as number) + share * (heights[first + place] as number);
    }
    for (let at = 0; at < 4 * stations; at += 4) {
      const [x, y, z] = [mean[at] as number, mean[at + 1] as number, mean[at + 2] as number];
      const high = radiusUnder(scalp, x, y, z) + (mean[at + 3] as number);
      const more = high / Math.max(radiusOf(x, y, z), 1e-6) - 1;
      if (more > 0) moveOutward(into, 4 * own + at, x, y, z, more);
    }
  }

  /** Room for the places of a strand, four numbers each: nothing is made anew for thousands of strands a frame. */
  private room(stations: number): Float64Array {
    if (this.places.length < 4 * stations) this.places = new Float64Array(4 * stations);
    return this.places;
  }

  private matched({ hair }: CarriedStyle, { hair: other }: CarriedStyle): Matches {
    const own = this.matches.get(hair) ?? new Map<HairStrands, Matches>();
    this.matches.set(hair, own);
    const matches = own.get(other) ?? (hair === other ? itself(hair) : matchRoots(hair, other));
    own.set(other, matches);
    return matches;
  }

  private study(hair: HairStrands): Study {
    const cached = this.studies.get(hair);
    if (cached !== undefined) return cached;
    const study = {
      wound: woundStrands(hair),
      heights: heightsOf(hair, this.scalp()),
      lengths: lengthsOf(hair),
      rooted: rootedOn(hair, this.painted),
    };
    this.studies.set(hair, study);
    return study;
  }
}

/** Every place at the root, and 0 beside it. */
function fillPlaces(places: Float64Array, values: Float32Array, root: number, stations: number): void {
  for (let place = 0; place < stations; place++) {
    for (let axis = 0; axis < 3; axis++) places[4 * place + axis] = values[root + axis] as number;
    places[4 * place + 3] = 0;
  }
}

/** Adds a share of a strand's course from its root; `width` numbers a place in `values`. */
function addCourse(
  places: Float64Array,
  values: Float32Array,
  width: number,
  first: number,
  share: number,
  stations: number,
): void {
  const root = width * first;
  for (let axis = 0; axis < 3; axis++) {
    const from = values[root + axis] as number;
    for (let place = 0; place < stations; place++)
      places[4 * place + axis] =
        (places[4 * place + axis] as number) + share * ((values[root + width * place + axis] as number) - from);
  }
}

/** Sets what each source gives to a strand; returns the weight of all that have hair at its root. */
function choose(sources: readonly StrandSource[], strand: number, stations: number): number {
  let weight = 0;
  for (const source of sources) weight += source.weight * (source.same[strand] as number);
  for (const source of sources) {
    source.share = weight > 0 ? (source.weight * (source.same[strand] as number)) / weight : 0;
    source.first = (source.strand[strand] as number) * stations;
  }
  return weight;
}

/** How much of a strand's width is drawn, 0..1: none of it where a heavier style draws the same hair. */
function widthOf(style: CarriedStyle, sources: readonly StrandSource[], strand: number): number {
  let [drawn, covered] = [0, 0];
  for (const source of sources)
    if (source.from === style) drawn = source.drawn;
    else covered = Math.max(covered, source.drawn * (source.same[strand] as number));
  return Math.max(drawn, 1 - covered);
}

/** Metres along a strand, as all its sources have it. */
function wholeLength(sources: readonly StrandSource[], strand: number): number {
  let sum = 0;
  for (const source of sources) sum += source.share * (source.lengths[source.strand[strand] as number] as number);
  return sum;
}

/** What is wound up shrinks to the skin at its root instead of being cut. */
function shrink(into: Float32Array, first: number, end: number, size: number): void {
  for (let at = first; at < end; at++) into[at] = size * (into[at] as number);
}

/** Every strand is its own match. */
function itself({ anchors }: HairStrands): Matches {
  return { strand: Int32Array.from(anchors.keys()), same: new Float32Array(anchors.length).fill(1) };
}

/** Metres over the scalp of every place of a style. */
function heightsOf({ points }: HairStrands, scalp: RadialMap): Float32Array {
  return Float32Array.from({ length: points.length / 3 }, (_, place) => {
    const at = points.subarray(3 * place, 3 * place + 3) as unknown as [number, number, number];
    return radiusOf(at[0], at[1], at[2]) - radiusUnder(scalp, at[0], at[1], at[2]);
  });
}

/** Metres along every strand of a style. */
const lengthsOf = ({ anchors, points, stations }: HairStrands): Float32Array =>
  Float32Array.from(anchors, (_, strand) => strandLength(points, strand * stations, stations));

/** How far every strand's root stands on painted scalp, 0..1. */
function rootedOn(
  { anchors, rows, weights, links, stations }: HairStrands,
  painted: (row: number) => number,
): Float32Array {
  return Float32Array.from(anchors, (_, strand) => {
    const root = strand * stations * links;
    let sum = 0;
    for (let link = root; link < root + links; link++) sum += (weights[link] as number) * painted(rows[link] as number);
    return sum;
  });
}
