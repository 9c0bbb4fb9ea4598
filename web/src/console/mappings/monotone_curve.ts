/** The curve through the knots of a target, as the engine plays it: a cubic between two knots that never turns there. */

export type Knot = readonly [at: number, gives: number];
export type Knots = readonly Knot[];

export const STRAIGHT: Knots = [
  [0, 0],
  [1, 1],
];
/** The radius of the circle, in slopes of the chord, within which a cubic between two knots is monotone. */
const STEEPEST = 3;

/** The slope at each knot (Fritsch and Carlson, 1980): the mean of both chords, none at a peak, never too steep. */
export function slopesAt(knots: Knots): number[] {
  const chords = pairs(knots).map(([[begin, low], [end, high]]) => (high - low) / (end - begin));
  const inner = pairs(chords).map(([before, after]) => (before * after <= 0 ? 0 : (before + after) / 2));
  const slopes = [chords[0] ?? 1, ...inner, chords.at(-1) ?? 1];
  for (const [place, chord] of chords.entries()) {
    if (chord === 0) {
      slopes[place] = slopes[place + 1] = 0;
      continue;
    }
    const [leaves, comes] = [(slopes[place] as number) / chord, (slopes[place + 1] as number) / chord];
    const steepness = Math.hypot(leaves, comes);
    if (steepness <= STEEPEST) continue;
    slopes[place] = (STEEPEST / steepness) * leaves * chord;
    slopes[place + 1] = (STEEPEST / steepness) * comes * chord;
  }
  return slopes;
}

/** What the curve gives at a place, 0..1. */
export function curveAt(knots: Knots, at: number): number {
  const slopes = slopesAt(knots);
  const piece = Math.max(
    0,
    Math.min(
      knots.length - 2,
      knots.findLastIndex(([begin]) => at >= begin),
    ),
  );
  const [[begin, low], [end, high]] = [knots[piece] as Knot, knots[piece + 1] as Knot];
  const [width, rise, part] = [end - begin, high - low, (at - begin) / (end - begin)];
  const [first, last] = [(slopes[piece] as number) * width, (slopes[piece + 1] as number) * width];
  const second = 3 * rise - 2 * first - last;
  const gives = low + part * (first + part * (second + part * (first + last - 2 * rise)));
  return Math.max(Math.min(low, high), Math.min(Math.max(low, high), gives));
}

/** The curve as a path of SVG; `place` puts a knot into the picture. */
export function pathOf(knots: Knots, place: (at: number, gives: number) => readonly [number, number]): string {
  const slopes = slopesAt(knots);
  const point = (at: number, gives: number): string => place(at, gives).map(rounded).join(" ");
  const pieces = pairs(knots).map(([[begin, low], [end, high]], piece) => {
    const third = (end - begin) / 3;
    const [leaves, comes] = [slopes[piece] as number, slopes[piece + 1] as number];
    return `C${point(begin + third, low + leaves * third)} ${point(end - third, high - comes * third)} ${point(end, high)}`;
  });
  return `M${point(...(knots[0] as Knot))}${pieces.join("")}`;
}

const rounded = (number: number): number => Math.round(number * 1e4) / 1e4;

const pairs = <Item>(items: readonly Item[]): (readonly [Item, Item])[] =>
  items.slice(1).map((item, at) => [items[at] as Item, item]);
