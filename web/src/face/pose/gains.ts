/** Gains: in which strength a face answers expressions, by region; the rules of `omote.model.space.gain` on pages. */

import { GAIN_RANGE, NEUTRAL_GAINS } from "../../link/constants";

export type GainRegion = keyof typeof NEUTRAL_GAINS;

/** A gain of a document or of a recipe; `expression` null: of all that have none of their own in this region. */
export interface Gain {
  readonly region: string;
  readonly value: number;
  readonly expression: string | null;
}

export const GAIN_REGIONS = Object.keys(NEUTRAL_GAINS) as readonly GainRegion[];

const ROUNDING = 1e-9;

/** The gain of a region for an expression by name: its own, else that for all, else the neutral one. */
export function gainOf(gains: readonly Gain[], region: string, expression: string | null = null): number {
  const here = gains.filter((gain) => gain.region === region);
  const own = expression === null ? undefined : here.find((gain) => gain.expression === expression);
  const all = own ?? here.find((gain) => gain.expression === null);
  return all?.value ?? NEUTRAL_GAINS[region as GainRegion] ?? 1;
}

/** Gains in one order, without those that say what holds without them. */
function tidied(gains: readonly Gain[]): Gain[] {
  const place = ({ region }: Gain) => GAIN_REGIONS.indexOf(region as GainRegion);
  const says = (gain: Gain): boolean => {
    const others = gains.filter((other) => other !== gain);
    return Math.abs(gain.value - gainOf(others, gain.region, gain.expression)) > ROUNDING;
  };
  const name = ({ expression }: Gain) => expression ?? "";
  return gains.filter(says).sort((gain, other) => place(gain) - place(other) || (name(gain) < name(other) ? -1 : 1));
}

const keyOf = ({ region, expression }: Gain): string => JSON.stringify([region, expression]);

/** The gains of a mix of faces: gains by shares that sum to one. */
export function mixGains(faces: readonly (readonly [readonly Gain[], number])[]): Gain[] {
  const kinds = new Map(faces.flatMap(([gains]) => gains.map((gain) => [keyOf(gain), gain] as const)));
  const [low, high] = GAIN_RANGE;
  const mixed = [...kinds.values()].map(({ region, expression }) => {
    const value = faces.reduce((sum, [gains, share]) => sum + share * gainOf(gains, region, expression), 0);
    return { region, value: Math.min(Math.max(value, low), high), expression };
  });
  return tidied(mixed);
}

/** The gains with those of each region from another face's. */
export function regionalGains(gains: readonly Gain[], regions: Readonly<Record<string, readonly Gain[]>>): Gain[] {
  const taken = Object.entries(regions).flatMap(([region, others]) => others.filter((gain) => gain.region === region));
  return tidied([...gains.filter(({ region }) => !(region in regions)), ...taken]);
}

/** The gains with own ones in place of those of the same region and expression. */
export function overrideGains(gains: readonly Gain[], own: readonly Gain[]): Gain[] {
  return tidied([...new Map([...gains, ...own].map((gain) => [keyOf(gain), gain])).values()]);
}
