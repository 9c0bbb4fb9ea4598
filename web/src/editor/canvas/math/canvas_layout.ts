/** How the canvas is shared out: the face under work large, the others beside it. */

import type { Box } from "./boxes";

export interface Tiles {
  work: Box;
  beside: Box[];
}

const GAP = 6; // CSS pixels between two faces
/** How much of the canvas is for the others at most: a few, and many. */
const FEW = { count: 4, share: 0.34 };
const MANY_SHARE = 0.5;

/** The boxes of the work and `count` faces beside it, in reading order: on the right of a wide canvas, else below. */
export function tiles(width: number, height: number, count: number): Tiles {
  if (count === 0) return { work: { left: 0, top: 0, width, height }, beside: [] };
  const wide = width >= height;
  const [long, short] = wide ? [width, height] : [height, width];
  const room = long * (count <= FEW.count ? FEW.share : MANY_SHARE);
  const lanes = lanesOf(room, short, count);
  const perLane = Math.ceil(count / lanes);
  const side = Math.min((short - GAP * (perLane - 1)) / perLane, room / lanes - GAP);
  const thick = lanes * (side + GAP);
  const along = (short - GAP * (perLane - 1)) / perLane;
  const beside = Array.from({ length: count }, (_, n): Box => {
    const [lane, place] = [Math.floor(n / perLane), n % perLane];
    const near = long - thick + GAP + lane * (side + GAP);
    const start = place * (along + GAP);
    return wide
      ? { left: near, top: start, width: side, height: along }
      : { left: start, top: near, width: along, height: side };
  });
  const work = wide
    ? { left: 0, top: 0, width: long - thick, height }
    : { left: 0, top: 0, width, height: long - thick };
  return { work, beside };
}

/** How many lanes make the faces largest. */
function lanesOf(room: number, short: number, count: number): number {
  const side = (lanes: number): number => {
    const perLane = Math.ceil(count / lanes);
    return Math.min((short - GAP * (perLane - 1)) / perLane, room / lanes - GAP);
  };
  let best = 1;
  for (let lanes = 2; lanes <= count; lanes++) if (side(lanes) > side(best) + 1e-9) best = lanes;
  return best;
}
