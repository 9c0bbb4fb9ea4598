/** Calls of expressions and poses in one region alone, and what is on air in regions. */

import { PLAY_REGIONS, type POSE_REGIONS } from "../../link/constants";
import type { CallExpression, CallFace, CallPose, CallState, CharacterState } from "../../link/messages";
import type { LookKind } from "./axis";

export type PlayRegion = (typeof PLAY_REGIONS)[number];
export type PoseRegion = (typeof POSE_REGIONS)[number];

/** Where calls of expressions can go: the whole face, then its regions. */
export const PLACES: readonly (PlayRegion | null)[] = [null, ...PLAY_REGIONS];

/** The message of a call; `region`: where alone an expression or a pose is called, null for the whole. */
export function callMessage(
  axis: LookKind,
  call: Omit<CallFace, "type">,
  region: PlayRegion | PoseRegion | null = null,
): CallFace | CallExpression | CallPose {
  if (axis === "pose") return { type: "call_pose", ...call, region: region as PoseRegion | null };
  return axis === "face"
    ? { type: "call_face", ...call }
    : { type: "call_expression", ...call, region: region as PlayRegion | null };
}

/** The place of the next key press after `place`, round and round. */
export function nextPlace(place: PlayRegion | null, direction: -1 | 1): PlayRegion | null {
  const at = PLACES.indexOf(place) + direction + PLACES.length;
  return PLACES[at % PLACES.length] ?? null;
}

/** What is called, on the whole face and in its regions. */
export const targetsOf = (call: CallState | null, regional: CharacterState["region_calls"] = {}): ReadonlySet<string> =>
  new Set([...(call ? [call] : []), ...Object.values(regional)].map(({ target }) => target));

/** What is on air of a name: its greatest weight anywhere, and the regions that show it. */
export interface ShownWeight {
  readonly weight: number;
  readonly regions: readonly PlayRegion[];
}

/** Weights below a thousandth are not shown. */
const LEAST = 0.001;

/** What is on air of an expression, where each region shows its own mix or that of the whole face. */
export function shownOf(name: string, state: Pick<CharacterState, "expressions" | "regions">): ShownWeight {
  const weights = PLAY_REGIONS.map((region) => (state.regions[region] ?? state.expressions)[name] ?? 0);
  const regions = PLAY_REGIONS.filter((_, at) => Math.abs(weights[at] ?? 0) >= LEAST);
  const weight = weights.reduce((most, value) => (Math.abs(value) > Math.abs(most) ? value : most), 0);
  return { weight, regions };
}

/** Where a name is on air, for a small corner: nothing where it is on the whole face or nowhere, `brows`, of several `B E`. */
export function regionMark({ regions }: ShownWeight): string {
  if (regions.length === PLAY_REGIONS.length) return "";
  if (regions.length === 1) return regions[0] as string;
  return regions.map((region) => region.charAt(0).toUpperCase()).join(" ");
}

/** The expression of a face at rest. */
const REST = "neutral";

type Mix = Readonly<Record<string, number>>;

/** The regions whose mix somebody has called. Speech, a tracker or a take has the face's own mix step back in a region,
 * and neutral take the rest, as far as its layer goes: that looks as the mix of the face, less of it, and is nobody's call. */
export function calledRegions({
  expressions,
  regions,
  layers,
}: Pick<CharacterState, "expressions" | "regions" | "layers">): CharacterState["regions"] {
  const sources = Object.values(layers).filter(({ source, share }) => source !== "" && share >= LEAST);
  if (sources.length === 0) return regions;
  const called = PLAY_REGIONS.flatMap((region, at): [PlayRegion, Mix][] => {
    const mix = regions[region];
    const kept = sources.reduce((left, { influence }) => left * (1 - (influence[at] ?? 0)), 1);
    return mix === undefined || isLess(mix, expressions, kept) ? [] : [[region, mix]];
  });
  return Object.fromEntries(called);
}

/** Whether a mix is that of the face, of which at least a share `kept` is left, with neutral in the place of the rest. */
function isLess(mix: Mix, whole: Mix, kept: number): boolean {
  const names = Object.keys({ ...mix, ...whole }).filter((name) => name !== REST);
  const most = names.reduce((largest, name) => Math.max(largest, Math.abs(whole[name] ?? 0)), 0);
  if (most < LEAST) return names.every((name) => Math.abs(mix[name] ?? 0) < LEAST);
  const loudest = names.find((name) => Math.abs(whole[name] ?? 0) === most) as string;
  const share = (mix[loudest] ?? 0) / (whole[loudest] as number);
  if (share < kept - LEAST || share > 1 + LEAST) return false;
  return names.every((name) => Math.abs((mix[name] ?? 0) - share * (whole[name] ?? 0)) < LEAST);
}

/** What regions show that somebody has called there, heaviest first in each: region, name and weight. */
export function regionalMixes(
  state: Pick<CharacterState, "expressions" | "regions" | "layers">,
): [PlayRegion, string, number][] {
  const regions = calledRegions(state);
  return PLAY_REGIONS.flatMap((region) =>
    Object.entries(regions[region] ?? {})
      .filter(([, weight]) => Math.abs(weight) >= LEAST)
      .sort(([, x], [, y]) => y - x)
      .map(([name, weight]): [PlayRegion, string, number] => [region, name, weight]),
  );
}
