/** How much of each look of a pad shows at a point: the page's twin of `perform/pads/soft_bands.py`, for its colours. */

export type PadPlace = readonly number[];

/**
 * The weights of some places at a point, each 0..1, together 1. A place weighs 1 / (1 + sum of g(t)) over the others, where
 * t goes from 0 at it to 1 at the other one and g(t) is nothing up to 0, (t / (1 - t)) to the power 1.5, and without end
 * from 1 on; then all are divided by their sum.
 */
export function softBands(places: readonly PadPlace[], point: PadPlace): number[] {
  const weights = places.map((place) => {
    let against = 1;
    for (const other of places) {
      if (other === place) continue;
      const along = alongWay(place, other, point);
      if (along >= 1) return 0;
      const ratio = along / (1 - along);
      if (along > 0) against += ratio * Math.sqrt(ratio);
    }
    return 1 / against;
  });
  const total = weights.reduce((sum, weight) => sum + weight, 0);
  return weights.map((weight) => weight / total);
}

/** How far a point is on the way from one place to another: 0 at the one, 1 at the other. */
function alongWay(from: PadPlace, to: PadPlace, point: PadPlace): number {
  let [dot, square] = [0, 0];
  for (const [axis, start] of from.entries()) {
    const way = (to[axis] as number) - start;
    dot += ((point[axis] as number) - start) * way;
    square += way * way;
  }
  return dot / square;
}
