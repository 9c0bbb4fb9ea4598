/** The channels in the order of a face and its body: regions from the brows down, left and right side by side. */

import type { ExpressionDocument } from "../../link/messages";

export const REGIONS = [
  "brows",
  "eyes",
  "nose",
  "cheeks",
  "mouth",
  "jaw",
  "tongue",
  "ears",
  "neck",
  "body",
  "face",
] as const;
export type Region = (typeof REGIONS)[number];
export type Side = "left" | "right";

/** One fader, or a pair of them under one name; `right` stands first, because the operator looks at the face. */
export interface Strip {
  readonly key: string;
  readonly label: string;
  /** The unit's own name, as files and trackers say it, without its side. */
  readonly unit: string;
  readonly kind: ExpressionDocument["kind"];
  readonly channels: readonly { readonly name: string; readonly side: Side | null }[];
}

const BEGINNINGS: readonly (readonly [string, Region])[] = [
  ["brow", "brows"],
  ["eyebrow", "brows"],
  ["eye", "eyes"],
  ["lid", "eyes"],
  ["nose", "nose"],
  ["cheek", "cheeks"],
  ["mouth", "mouth"],
  ["lip", "mouth"],
  ["jaw", "jaw"],
  ["tongue", "tongue"],
  ["ear", "ears"],
  ["neck", "neck"],
];

/** The region of an expression: the one its document names, else the one its name begins with, else the whole face. */
export function regionOf(expression: Pick<ExpressionDocument, "name" | "kind" | "region">): Region {
  const said = expression.region.toLowerCase();
  const namedRegion = REGIONS.find((region) => region === said || region === `${said}s`);
  if (namedRegion !== undefined) return namedRegion;
  if (expression.kind === "performed" || expression.kind === "neutral") return "face";
  const name = expression.name.toLowerCase();
  return BEGINNINGS.find(([beginning]) => name.startsWith(beginning))?.[1] ?? "face";
}

/** The side that a name speaks of, and the name without it: `mouthSmileLeft` gives left and `mouthSmile`. */
export function sideOf(name: string): { side: Side | null; stem: string } {
  const camel = /^(.*[a-z])(Left|Right)$/.exec(name);
  // jawLeft and mouthLeft are directions: their right is an opposite, not a mirror of the same move
  if (camel?.[1] !== undefined && camel[2] !== undefined && camel[1] !== "jaw" && camel[1] !== "mouth")
    return { side: camel[2] === "Left" ? "left" : "right", stem: camel[1] };
  const dashed = /^([a-z]+)-(left|right)-(.*)$/.exec(name);
  if (dashed) return { side: dashed[2] === "left" ? "left" : "right", stem: `${dashed[1]}-${dashed[3]}` };
  return { side: null, stem: name };
}

/** A label without its side, which the place of a fader in its pair says: `Brow down, left` gives `Brow down`. */
export const withoutSide = (label: string): string => label.replace(/, (left|right)$/, "");

/** The faders of some expressions, in their order: a pair where both sides are there, else single ones. */
export function stripsOf(expressions: readonly ExpressionDocument[]): Strip[] {
  const strips = new Map<string, Strip>();
  for (const { name, label, kind } of expressions) {
    if (kind === "neutral") continue;
    const { side, stem } = sideOf(name);
    const key = `${kind}:${stem}`;
    const channels = [...(strips.get(key)?.channels ?? []), { name, side }];
    channels.sort((a, b) => Number(a.side === "left") - Number(b.side === "left"));
    strips.set(key, { key, kind, label: side === null ? label : withoutSide(label), unit: stem, channels });
  }
  return [...strips.values()];
}

/** The regions that have faders, each with its expressions, from the brows down. */
export function byRegion(expressions: readonly ExpressionDocument[]): Map<Region, ExpressionDocument[]> {
  const regions = new Map<Region, ExpressionDocument[]>();
  for (const region of REGIONS) {
    const inside = expressions.filter((expression) => expression.kind !== "neutral" && regionOf(expression) === region);
    if (inside.length > 0) regions.set(region, inside);
  }
  return regions;
}

/** The channel that moves the same on the other side, if there is one. */
export function mirrorOf(name: string, strips: readonly Strip[]): string | null {
  const strip = strips.find((candidate) => candidate.channels.some((channel) => channel.name === name));
  return strip?.channels.find((channel) => channel.name !== name)?.name ?? null;
}
