/** The measures of teeth, and the outline of one across its width: crown, gum line and what lies behind. */

import { JAWS as MEASURES } from "../../link/constants";

/** A tooth; millimetres. One of no height has not come through: where it is, gum is as high as its edge would be. */
export interface Tooth {
  readonly width: number;
  /** From the gum line in its middle to its edge. */
  readonly height: number;
  /** From outside to inside where it leaves the gum, and at its edge. */
  readonly depth: number;
  readonly edge: number;
  /** How far its corners lie behind its middle, and the power by which they do: 1.3 is a point, 4 a round corner. */
  readonly corner: number;
  readonly power: number;
  /** How far the middle of a grinding face is hollowed. */
  readonly hollow: number;
  /** How far its edge stands out of the row's. */
  readonly over: number;
}

/** The teeth of one half of a jaw from the middle, and where the row lies in its cage; millimetres. */
export interface Row {
  readonly teeth: readonly Tooth[];
  /** How far the row's edge stands beyond the cage's, and how far inside of the cage it lies. */
  readonly over: number;
  readonly inside: number;
  /** How far above the cage's gum the palate is in its middle; the floor of the mouth: below, less than 0. */
  readonly vault: number;
}

/** Whose teeth: those of the face at rest, a baby's, and those that fur brings (a carnivore's). */
export interface Jaw {
  readonly person: Row;
  readonly milk: Row;
  readonly carnivore: Row;
}

export const JAWS: { readonly upper: Jaw; readonly lower: Jaw } = MEASURES;

/** Rows across a jaw: from the outer gum over the crown to the inner gum, then to the middle of palate or floor. */
export const RIBS = 18;

/**
 * A point of the outline: `up` towards the gum and `inward`, millimetres from the cage's edge and outer side; `height`: 0
 * at the gum line, 1 at the edge, less than 0 on gum; `across`: share of the way to the same place on the other side.
 */
export interface Rib {
  readonly up: number;
  readonly inward: number;
  readonly height: number;
  readonly across: number;
}

/** How far the drawn gum ends before the cage's, and inside of it: there it comes through cheeks first; millimetres. */
const SHORT = 3;
const UNDER = 3;

/** Molars have less gum than this in their cage, and as much above them; millimetres. */
const LOWEST_GUM = 18;

/** How much of the way from edge to gum a crown may take. */
const MOST = 0.66;

/** How far up the crown its outline is followed on the outer side, and by how much it is rounded in there, millimetres. */
const FRONT: readonly (readonly [number, number])[] = [
  [0.02, 0.8],
  [0.22, 0.22],
  [0.5, 0],
  [0.8, 0.35],
  [0.95, 0.85],
];

/** Places behind the last tooth, in halves of its width from its middle, at which the gum goes on; at the last it is gone. */
export const BEYOND = [1.12, 1.7, 2.7] as const;

/**
 * The outline of a tooth at `t` (-1..1 across it); `reach`: millimetres from the cage's edge to its gum. The gum climbs
 * between teeth (papillae), the crown's corners are round, and its sides go in, so that teeth stand apart. Beyond -1 and 1
 * there is gum alone, which sinks up to the last place of BEYOND: so a row's end is closed.
 */
export function outline(of: Tooth, row: Row, t: number, reach: number): Rib[] {
  const far = Math.abs(t);
  const high = Math.max(reach, LOWEST_GUM) + row.vault;
  const behind = of.depth + 2;
  return [
    ...(far <= 1 && of.height > 0 ? crown(of, row, far, reach) : ridge(of, row, far, reach)),
    { up: 0.85 * high, inward: behind, height: -0.6, across: 0.2 },
    { up: high, inward: behind, height: -1, across: 0.5 },
  ].map((rib) => ({ ...rib, inward: row.inside + rib.inward }));
}

const rib = (up: number, inward: number, height: number): Rib => ({ up, inward, height, across: 0 });

/** Gum without a tooth, and behind the last one: half an ellipse over palate or floor. */
function ridge(of: Tooth, row: Row, far: number, reach: number): Rib[] {
  const gum = Math.min(of.height - of.over - row.over, MOST * reach);
  const low = Math.max(reach - SHORT, gum + 1.5);
  const left = (BEYOND[2] - Math.max(far, 1)) / (BEYOND[2] - 1);
  const last = RIBS - 3;
  return Array.from({ length: RIBS - 2 }, (_, n) => {
    const around = (Math.PI * n) / last;
    const rise = left * Math.sin(around);
    const beside = UNDER + (of.depth + 1.1 - UNDER) * (0.5 - 0.5 * Math.cos(around));
    return rib(low - (low - gum) * rise, beside, 0.88 * rise - 1);
  });
}

function crown(of: Tooth, row: Row, far: number, reach: number): Rib[] {
  const edge = of.corner * far ** of.power - of.over - row.over;
  const full = Math.min(of.height - of.over - row.over, MOST * reach);
  const front = full - 0.4 * of.height * far ** 2.4;
  const back = full - 0.28 * of.height * far ** 2.4;
  const aside = 0.45 * far * far + 1.1 * far ** 5;
  const last = reach - SHORT;
  const ground = of.hollow > 0 ? 0.28 * of.depth : 0.6;
  const inner = ground + of.edge;
  const neck = of.depth - 0.4 - aside;
  const enamel = (gum: number, share: number, inward: number): Rib => rib(gum + (edge - gum) * share, inward, share);
  return [
    rib(Math.max(last, front + 1.5), UNDER, -1),
    rib(Math.max(front + 1.2, 0.5 * (front + last)), 0.7, -0.55),
    rib(front + 0.8, -0.1 + 0.4 * aside, -0.12),
    rib(front - 0.1, 0.2 + 0.55 * aside, -0.01),
    ...FRONT.map(([share, inward]) => enamel(front, share, inward + aside)),
    rib(edge, Math.min(ground + aside, neck), 1),
    rib(edge + of.hollow * (1 - far * far), Math.min(ground + 0.5 * of.edge, neck), 1),
    rib(edge + 0.1, Math.min(inner, neck + 0.2), 1),
    enamel(back, 0.6, 0.5 * (inner + neck)),
    enamel(back, 0.15, neck),
    rib(back - 0.05, of.depth, -0.01),
    rib(back + 0.25 * (last - back), of.depth + 1.1, -0.3),
  ];
}
