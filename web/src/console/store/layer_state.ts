/** The layers of a character as a console shows them: also those of which the state says nothing, which are as at first. */

import { DRIVEN_LAYERS, LAYER_PARTS, type LAYERS, LIPS_INFLUENCE } from "../../link/constants";
import type { CharacterState, GazeTargetState, LayerState } from "../../link/messages";
import { handsOf } from "./held_state";
import { sourceLabel } from "./source_label";

export type LayerName = (typeof LAYERS)[number];
export type LayerPart = (typeof LAYER_PARTS)[number];

/** The target of eyes that look at nothing. */
export const AHEAD: GazeTargetState = { kind: "ahead", name: "", yaw: 0, pitch: 0, x: 0, y: 0, z: 2 };

/** Channels by which a layer shows what it does now. */
const MOST_SHOWN = 3;
const LEAST_SHOWN = 0.02;
/** A trust that is this near to its end is there. */
const NEAR = 0.001;

export const isDriven = (layer: LayerName): boolean => DRIVEN_LAYERS.some((driven) => driven === layer);

/** The influence of a layer at first, by part. */
export const firstInfluence = (layer: LayerName): readonly number[] =>
  layer === "lips" ? LIPS_INFLUENCE : LAYER_PARTS.map(() => 1);

/** A layer of a character, and what it does now. */
export function layerOf(state: CharacterState, layer: LayerName): LayerState {
  const layerState = state.layers[layer] ?? first(layer);
  return isDriven(layer) ? layerState : { ...layerState, strongest: strongest(playedAs(state, layer)) };
}

function first(layer: LayerName): LayerState {
  const share = isDriven(layer) ? 0 : 1;
  return { influence: [...firstInfluence(layer)], on: true, trust: 1, source: "", share, strongest: {}, sources: [] };
}

/** What calls and hands play. */
const playedAs = (state: CharacterState, layer: LayerName): Readonly<Record<string, number>> =>
  layer === "emotion" ? state.expressions : handsOf(state).channels;

function strongest(weights: Readonly<Record<string, number>>): Record<string, number> {
  const seen = Object.entries(weights).filter(([, weight]) => Math.abs(weight) >= LEAST_SHOWN);
  return Object.fromEntries(
    seen.sort(([, weight], [, other]) => Math.abs(other) - Math.abs(weight)).slice(0, MOST_SHOWN),
  );
}

/** The influence of a layer on a part; on the whole, `null`, where it is largest. */
export function influenceOf(state: CharacterState, layer: LayerName, part: LayerPart | null): number {
  const { influence } = layerOf(state, layer);
  return part === null ? Math.max(...influence) : (influence[LAYER_PARTS.indexOf(part)] ?? 0);
}

/** A source that is trusted so far sends no more, or all that it sends shows. */
export const isLost = (trust: number): boolean => trust < NEAR;
export const isTrusted = (trust: number): boolean => trust > 1 - NEAR;

/** What a layer does now as far as its source is trusted: nothing of one that is lost. */
export function shownChannels({ source, trust, strongest }: LayerState): readonly (readonly [string, number])[] {
  if (source === "") return Object.entries(strongest);
  return isLost(trust) ? [] : Object.entries(strongest).map(([name, weight]) => [name, trust * weight]);
}

/** Where the trust of a source goes: `rises` is kept while it stands still. */
export interface Trend {
  readonly trust: number;
  readonly rises: boolean;
}

/** The trend one state later; `null` before the first. */
export function followTrend(before: Trend | null, trust: number): Trend {
  if (before === null) return { trust, rises: trust > NEAR };
  return trust === before.trust ? before : { trust, rises: trust > before.trust };
}

/** Who feeds a layer, in words: calls and hands, or its source and how far that is trusted. `names`: of all sources. */
export function feedWords(
  layer: LayerName,
  { source, sources }: LayerState,
  { trust, rises }: Trend,
  names: readonly string[] = [],
): string {
  if (layer === "emotion") return "calls";
  if (layer === "hands") return "faders, pads";
  if (source === "") return "no source";
  if (sources.length > 1) return sources.map((layerSource) => sharedWords(layerSource, names)).join(", ");
  const label = sourceLabel(source, names);
  if (isTrusted(trust)) return label;
  if (isLost(trust)) return `${label}: lost`;
  return `${label}: ${rises ? "returning" : "fading"}`;
}

/** One of several sources of a layer, and the parts that it has. */
const sharedWords = ({ source, trust, parts }: LayerState["sources"][number], names: readonly string[]): string =>
  `${sourceLabel(source, names)}: ${parts.length > 0 ? parts.join(" ") : isLost(trust) ? "lost" : "waits"}`;
