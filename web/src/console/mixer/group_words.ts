/** How things stand in each group of the mixer, in a few words: what its head says while another group is shown. */

import type { CharacterState, SourceState } from "../../link/messages";
import { AHEAD, influenceOf, type LayerName, layerOf } from "../store/layer_state";
import { sourceLabel } from "../store/source_label";
import { unrouted } from "./unrouted_sources";

/** What a head says, and whether it wants attention. */
export interface GroupWords {
  readonly text: string;
  readonly wanted: boolean;
}

const groupWords = (text: string, wanted = false): GroupWords => ({ text, wanted });
const percent = (share: number): number => Math.round(100 * share);

/** A source that is not heard any more, or that sees nobody. */
const isSilent = ({ rate, found }: SourceState): boolean => rate === 0 || !found;

/** Sources: who is lost, who plays nobody, else who sends. */
export function sourceWords(sources: readonly SourceState[]): GroupWords {
  const [first] = sources;
  if (first === undefined) return groupWords("none sends");
  const silent = sources.filter((source) => source.kind !== "program" && isSilent(source)).length;
  const idle = unrouted(sources).length;
  if (silent > 0) return groupWords(sources.length === 1 ? "lost" : `${silent} of ${sources.length} lost`, true);
  if (idle > 0) return groupWords(idle === 1 ? "1 plays nobody" : `${idle} play nobody`, true);
  return groupWords(sources.length === 1 ? sourceLabel(first.name) : `${sources.length} play`);
}

/** Parts: the influence of a layer, where it is the same everywhere, or from the least to the most. */
export function partWords(air: CharacterState, layer: LayerName): GroupWords {
  const { influence, on } = layerOf(air, layer);
  if (!on) return groupWords("off", true);
  const [least, most] = [percent(Math.min(...influence)), percent(influenceOf(air, layer, null))];
  return groupWords(least === most ? String(most) : `${least} to ${most}`);
}

/** By itself: how lively, or whether it lives on in a tracker's place, now or when that is lost. */
export function motionWords({ motion, layers }: CharacterState): GroupWords {
  if (motion === null || motion === undefined) return groupWords("holds still");
  if (motion.liveliness > 0) return groupWords(`liveliness ${percent(motion.liveliness)}`);
  if (motion.idle) return layers.breath?.source ? groupWords("idles now", true) : groupWords("idles if lost");
  return groupWords("holds still");
}

/** Looks at: the name of what it looks at. */
export function targetWords(
  { motion }: CharacterState,
  characters: Readonly<Record<string, { label: string }>>,
): GroupWords {
  const { kind, name } = motion?.target ?? AHEAD;
  if (kind === "ahead") return groupWords("ahead");
  if (kind === "stage") return groupWords(name === "" ? "the camera" : `camera ${name}`);
  if (kind === "character") return groupWords(characters[name]?.label ?? name);
  return groupWords(kind === "gaze_point" ? name : "a point");
}

/** Says: what is said now. */
export function saysWords({ speech }: CharacterState): GroupWords {
  if (speech === null || speech === undefined) return groupWords("nothing");
  return groupWords(speech.text === "" ? "speaks" : speech.text);
}
