import { LEVELS } from "../../face/quality/quality_levels";
import type { StageReport } from "../../link/messages";

/** The quality that the stages draw at: one level, or from the lowest to the highest of theirs; empty: none says. */
export function levelsOf(stages: readonly (StageReport | null)[]): string {
  const used = LEVELS.filter((level) => stages.some((stage) => stage?.level === level));
  const [lowest, highest] = [used[0], used.at(-1)];
  if (lowest === undefined) return "";
  return lowest === highest ? lowest : `${lowest} to ${highest}`;
}
