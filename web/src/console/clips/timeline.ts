/** The time line of a clip as numbers: what it spans, where its marks stand, what a lane is called in a message. */

import type { ClipOutline, LaneOutline } from "../../link/messages";

/** From where to where, seconds of the clip. */
export interface Span {
  readonly from: number;
  readonly to: number;
}

const SHORTEST_VIEW = 10;
const STEPS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600];
/** Pixels between two numbers of the ruler. */
const APART = 64;

/** Seconds that the line shows: all lanes, the trim and what is recorded, and never a sliver. */
export function viewSpan(outline: ClipOutline | null, position: number): Span {
  const lanes = outline?.lanes ?? [];
  const from = Math.min(0, outline?.start ?? 0, ...lanes.map(({ start }) => start));
  const to = Math.max(outline?.stop ?? 0, ...lanes.map(({ stop }) => stop), from);
  const length = Math.max(SHORTEST_VIEW, (to - from) * 1.04);
  if (position <= from + length) return { from, to: from + length };
  return { from, to: from + Math.ceil((position - from) / SHORTEST_VIEW + 1) * SHORTEST_VIEW }; // it grows in steps
}

/** The seconds at which a ruler has numbers, of so many pixels a second. */
export function rulerMarks({ from, to }: Span, pixels: number): number[] {
  const step = STEPS.find((candidate) => candidate * pixels >= APART) ?? 1800;
  const first = Math.ceil(from / step - 1e-6);
  const count = Math.max(0, Math.floor(to / step + 1e-6) - first + 1);
  return Array.from({ length: count }, (_, index) => Math.round((first + index) * step * 1000) / 1000);
}

/** A span between two places, in order; null where nothing lies between them. */
export function spanBetween(one: number, other: number): Span | null {
  const [from, to] = one < other ? [one, other] : [other, one];
  return to - from < 0.05 ? null : { from, to };
}

/** What a lane is called in a message: its number from 1, unless another is named so. */
export function laneKey(lanes: readonly Pick<LaneOutline, "name">[], index: number): string {
  const names = lanes.map(({ name }, place) => name || String(place + 1));
  const number = String(index + 1);
  const named = names.indexOf(number);
  return named === -1 || named === index ? number : (names[index] ?? number);
}

/** A name that no lane has yet. */
export function freeLaneName(lanes: readonly Pick<LaneOutline, "name">[], wanted: string): string {
  const names = new Set(lanes.map(({ name }) => name));
  const candidates = Array.from({ length: lanes.length + 2 }, (_, place) =>
    place === 0 ? wanted : `${wanted} ${place + 1}`,
  );
  return candidates.find((candidate) => !names.has(candidate)) ?? wanted;
}

/** The path of a curve in a box of a width and 100 in height: weights from 0 at its foot, angles about its middle. */
export function curvePath(values: readonly number[], turns: boolean): string {
  const last = Math.max(1, values.length - 1);
  const height = (value: number): number => {
    const part = turns ? 0.5 + value : value;
    return 96 - 92 * Math.min(1, Math.max(0, part));
  };
  return values
    .map(
      (value, place) => `${place === 0 ? "M" : "L"}${((1000 * place) / last).toFixed(1)} ${height(value).toFixed(1)}`,
    )
    .join("");
}

/** What a column is called beside its curve: `jawOpen`, `mouth joy`, `head yaw`. */
export const columnLabel = (column: string): string => column.replace(/^channel\//, "").replace("/", " ");
