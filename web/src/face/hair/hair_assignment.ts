/** Which hair styles the faces on air have, how much of each is grown, and their strands. */

import type { Library } from "../../link/assets";
import type { HairStrands } from "../../link/strands";
import { rowTriangles } from "../anatomy/topology";
import { type CarriedStyle, HairBlend } from "./hair_blend";
import { mixRoots, rootDensity } from "./hair_roots";
import { drawnStrands, mixOffsets, type Offsets, offsetsOn, styleWeights, weightOfLate } from "./hair_strands";
import { type RadialMap, radialMap } from "./radial_map";

const CATCH_UP = 0.25; // seconds in which a style that came late grows in

/** A style as it is worn now. */
export interface ActiveStyle extends CarriedStyle {
  readonly name: string;
  /** Metres from the skin at each strand's root, shaped by all styles on air, with lengths and widths: see `HairBlend`. */
  readonly strands: Float32Array;
  scalp: number;
  /** Rises when the strands change. */
  version: number;
  /** How much shows of the strand that shows most: 0 none of it, 1 all. */
  grown: number;
}

/** What all characters share of hair: how styles blend on the generic head, how each face carries each style, and how densely each
 * grows; "" is the shade of hair on who wears none. */
export interface HairStock {
  readonly blend: HairBlend;
  readonly offsets: Map<string, Offsets>;
  readonly density: Map<string, Float32Array>;
}

/** An empty stock; `generic`: the face that styles are made on; `painted`: the rows of its skin under hair, 0..1 each. */
export function createHairStock(library: Library, generic: Float32Array, painted: (row: number) => number): HairStock {
  let scalp: RadialMap | undefined;
  const grow = (): RadialMap => {
    scalp ??= radialMap(generic, library.meshes.filter(({ name }) => name === "skin").map(rowTriangles));
    return scalp;
  };
  const bare = Float32Array.from({ length: generic.length / 3 }, (_, row) => painted(row));
  return { blend: new HairBlend(grow, painted), offsets: new Map(), density: new Map([["", bare]]) };
}

/** What of the cast's hair is here, and how the faces on air wear it; a style that comes late grows in. */
export class HairAssignment {
  private readonly faces = new Map<string, Float32Array>();
  private readonly asked = new Map<string, Promise<unknown>>();
  private readonly shares = new Map<string, number>();
  private coming = 0;
  private shaped = "";
  /** How densely hair grows at each row, 0..1, mixed over the faces on air, and a number that rises when it changes. */
  readonly roots: Float32Array;
  rooted = 0;
  /** The largest share of a style's strands that anybody draws, 0..1. */
  detail = 1;
  /** The weights of the faces on air that are here. */
  dressed: ReadonlyMap<string, number> = new Map();
  /** Every style that has come, by name: in whatever order they came, sums are the same to the last bit. */
  readonly worn = new Map<string, ActiveStyle>();

  constructor(
    private readonly library: Library,
    private readonly generic: Float32Array,
    private readonly stock: HairStock,
  ) {
    this.roots = new Float32Array(generic.length / 3);
  }

  /** Fetches what these faces wear, and the faces, which all styles on air must fit. */
  want(faces: Iterable<string>): void {
    for (const face of faces) {
      if (!this.library.hasFace(face)) continue;
      this.ask(`face ${face}`, async () => this.faces.set(face, await this.library.positions(face)));
      const style = this.styleOf(face);
      if (style !== "") this.ask(`style ${style}`, async () => this.take(style, await this.library.hair(style)));
    }
  }

  /** Waits until everything that was ever wanted has come, or was refused. */
  async complete(): Promise<void> {
    await Promise.all(this.asked.values());
  }

  /** Whether all that was wanted has come, or was refused. */
  get here(): boolean {
    return this.coming === 0;
  }

  /** Whether all that was wanted has come, or was refused, and has grown in. */
  get settled(): boolean {
    return this.here && [...this.worn.keys()].every((style) => (this.shares.get(style) ?? 0) >= 1);
  }

  /** Dresses the faces on air, by weight, `seconds` after the last frame; `atOnce`: in full. */
  dress(faces: ReadonlyMap<string, number>, seconds: number, atOnce: boolean): void {
    const here = new Map([...faces].filter(([face]) => this.faces.has(face)));
    const styles = styleWeights(here, (face) => this.styleOf(face));
    this.dressed = here;
    const weights = new Map<ActiveStyle, number>();
    for (const style of this.worn.values()) {
      const wearers = styles.get(style.name) ?? new Map<string, number>();
      const weight = [...wearers.values()].reduce((sum, part) => sum + part, 0);
      const share = Math.min(1, (this.shares.get(style.name) ?? 0) + (atOnce ? 1 : seconds / CATCH_UP));
      this.shares.set(style.name, weight > 0 ? share : 1); // what comes while nobody wears it needs no easing
      if (weight <= 0) continue;
      weights.set(style, weight * weightOfLate(share));
      style.scalp = [...wearers].reduce((sum, [face, part]) => sum + (part / weight) * this.scalpOf(face), 0);
    }
    this.shape(here, weights);
  }

  /** Shapes every style on air by all of them; what weighs nothing shows nothing. */
  private shape(faces: ReadonlyMap<string, number>, weights: ReadonlyMap<ActiveStyle, number>): void {
    const key = JSON.stringify([[...faces], [...weights].map(([{ name }, weight]) => [name, weight]), this.detail]);
    if (key === this.shaped) return;
    this.shaped = key;
    this.root(faces, weights);
    for (const style of weights.keys()) this.carry(style, faces);
    for (const style of this.worn.values()) {
      style.grown = 0;
      if (!weights.has(style)) continue;
      style.grown = this.stock.blend.write(style, weights, style.strands, drawnStrands(style.hair, this.detail));
      style.version += 1;
    }
  }

  /** The shade of the roots of all styles on air, and of who wears none. */
  private root(faces: ReadonlyMap<string, number>, weights: ReadonlyMap<ActiveStyle, number>): void {
    const bare = [...faces].filter(([face]) => this.styleOf(face) === "");
    const shade = bare.reduce((sum, [face, weight]) => sum + weight * this.scalpOf(face), 0);
    const worn = [...weights].map(([style, weight]) => [this.densityOf(style), weight] as const);
    mixRoots([...worn, [this.stock.density.get("") as Float32Array, shade]], this.roots);
    this.rooted += 1;
  }

  private densityOf({ name, hair }: ActiveStyle): Float32Array {
    const density = this.stock.density.get(name) ?? rootDensity(hair, this.generic, this.library.manifest.skin);
    this.stock.density.set(name, density);
    return density;
  }

  private styleOf(face: string): string {
    return this.library.faces.get(face)?.look.hair_style ?? "";
  }

  private scalpOf(face: string): number {
    return this.library.faces.get(face)?.look.scalp ?? 1;
  }

  /** A style on the mix of the faces on air. */
  private carry(style: ActiveStyle, faces: ReadonlyMap<string, number>): void {
    const total = [...faces.values()].reduce((sum, weight) => sum + weight, 0) || 1;
    const parts = [...faces].map(([face, weight]) => [this.offsetsOf(style, face), weight / total] as const);
    mixOffsets(parts, style.carried);
  }

  private offsetsOf(style: ActiveStyle, face: string): Offsets {
    const key = `${style.name}\n${face}`;
    const offsets =
      this.stock.offsets.get(key) ?? offsetsOn(style.hair, this.generic, this.faces.get(face) as Float32Array);
    this.stock.offsets.set(key, offsets);
    return offsets;
  }

  private take(name: string, hair: HairStrands): void {
    const [strands, carried] = [0, 1].map(() => new Float32Array((4 * hair.points.length) / 3));
    const style = { name, hair, strands, carried, scalp: 1, version: 0, grown: 0 } as ActiveStyle;
    const styles = [...this.worn.values(), style].sort((a, b) => (a.name < b.name ? -1 : 1));
    this.worn.clear();
    for (const activeStyle of styles) this.worn.set(activeStyle.name, activeStyle);
  }

  private ask(key: string, read: () => Promise<unknown>): void {
    if (this.asked.has(key)) return;
    this.coming += 1;
    this.asked.set(
      key,
      read()
        .catch((error: unknown) => console.warn(String(error)))
        .then(() => {
          this.coming -= 1;
        }),
    );
  }
}
