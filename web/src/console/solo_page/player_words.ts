/** Which sources play a character, in a few words. */

import { ROUTE_PARTS } from "../../link/constants";
import type { SourceState } from "../../link/messages";
import { sourceLabel } from "../store/source_label";

/** Who of those who send plays a character, in which parts, and who is lost; "" for nobody. `character`: its name. */
export function playersWords(sources: readonly SourceState[], character: string): string {
  const names = sources.map(({ name }) => name);
  const plays = ({ name, regions, rate, found }: SourceState): string => {
    const label = sourceLabel(name, names);
    if (rate === 0 || !found) return `${label}: lost`;
    const all = regions.length === 0 || regions.length === ROUTE_PARTS.length;
    return `${label}: ${all ? "all parts" : regions.join(", ")}`;
  };
  return sources
    .filter(({ characters }) => characters.includes(character))
    .map(plays)
    .join("; ");
}
