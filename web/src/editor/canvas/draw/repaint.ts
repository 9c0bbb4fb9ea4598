/** Which part of a face's picture must be drawn anew when a hand moves some of its rows: pixels are what drawing costs. */

import { type Box, contains, expanded, overlap, union } from "../math/boxes";

/** The box of the canvas that a cut of a head's triangles serves, while no row goes further than `reach`, metres. */
export interface Cover {
  readonly box: Box;
  readonly reach: number;
}

const NOWHERE: Cover = { box: { left: 0, top: 0, width: -1, height: -1 }, reach: 0 };

/** Remembers what of a face was drawn anew the time before, for what moved has to go from there too; and the last cut. */
export class Repaint {
  private before: Box | undefined;
  private covered = NOWHERE;

  /** The face is drawn whole, perhaps from somewhere else. */
  forget(): void {
    [this.before, this.covered] = [undefined, NOWHERE];
  }

  /** The cut to make for a part of the tile, no row of which goes further than `reach`; undefined: the last one serves. */
  cover(part: Box, reach: number): Cover | undefined {
    if (contains(this.covered.box, part) && reach <= this.covered.reach) return undefined;
    this.covered = { box: expanded(part), reach: 2 * reach };
    return this.covered;
  }

  /** What of the face's tile is to be drawn when `box` of it changes. */
  next(box: Box, tile: Box): Box {
    const { before } = this;
    this.before = box;
    return overlap(before === undefined ? box : union(before, box), tile);
  }
}
