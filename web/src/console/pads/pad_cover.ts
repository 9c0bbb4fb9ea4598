/** What lies over the mix that a pad plays: the parts of the face that a source has, and which. Nothing here touches the page. */

import { LAYER_PARTS, PLAY_REGIONS } from "../../link/constants";
import type { CharacterState, LayerSource, LayerState, SourceState } from "../../link/messages";
import { layerOf } from "../store/layer_state";
import type { PlayRegion } from "../store/region_calls";
import { sourceLabel } from "../store/source_label";
import { type PadPart, restOf } from "./pad_layout";

/** The layers above called expressions that take the place of these, the highest first. */
const ABOVE = ["playback", "lips", "tracker"] as const;
/** From this share on, a part shows more of what lies above than of the pad. */
const MOSTLY = 0.5;

/** Where a pad is covered: `whole` where nothing of it shows; `words`: by whom and where, "" for nowhere. */
export interface PadCover {
  readonly whole: boolean;
  readonly words: string;
}

/** What covers a pad of a character. `part`: what it plays; `sources`: all that send, whose names and parts are known. */
export function coverOf(
  part: PadPart,
  air: Pick<CharacterState, "layers" | "regions" | "expressions">,
  sources: readonly SourceState[],
): PadCover {
  const played = part === "face" || part === "pose" ? [] : part === "expression" ? PLAY_REGIONS : [part];
  const covered = played.flatMap((region) => {
    const who = hasStepped(air, region) ? whoCovers(region, air as CharacterState, sources) : null;
    return who === null ? [] : [[region, who] as const];
  });
  if (covered.length === 0) return { whole: false, words: "" };
  const names = sources.map(({ name }) => name);
  const by = `covered by ${[...new Set(covered.map(([, who]) => sourceLabel(who, names)))].join(", ")}`;
  const whole = covered.length === played.length;
  return { whole, words: whole ? by : `${covered.map(([region]) => region).join(", ")} ${by}` };
}

/** Whether the mix of expressions has stepped back in a region, where it is neutral. */
const hasStepped = (
  { regions, expressions }: Pick<CharacterState, "regions" | "expressions">,
  region: PlayRegion,
): boolean => ((regions[region] ?? expressions)[restOf("expression")] ?? 0) > MOSTLY;

/** The source that has a part more than what is called there; null for none. */
function whoCovers(part: PlayRegion, air: CharacterState, sources: readonly SourceState[]): string | null {
  for (const layer of ABOVE) {
    const state = layerOf(air, layer);
    if (!state.on) continue;
    const influence = state.influence[LAYER_PARTS.indexOf(part)] ?? 0;
    const has = sharing(state, sources).find(({ parts, trust }) => parts.includes(part) && influence * trust > MOSTLY);
    if (has !== undefined) return has.source;
  }
  return null;
}

/** The sources of a layer with the parts that each has: of one alone those that it may play. */
function sharing({ source, trust, sources: several }: LayerState, all: readonly SourceState[]): readonly LayerSource[] {
  if (several.length > 0) return several;
  const alone = all.find(({ name }) => name === source);
  if (alone === undefined) return []; // nobody who sends: a clip, speech
  return [{ source, trust, parts: alone.regions.length > 0 ? alone.regions : [...LAYER_PARTS] }];
}
