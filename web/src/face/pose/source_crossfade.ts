/** Crossfades a name on air from its old source to its new one. */

import { MathUtils } from "three";
import type { SourceKind as Kind } from "../../link/assets";
import { expressionNames } from "./mix_terms";
import type { FigureMix, Pose } from "./pose";

type Weights = Record<string, number>;

/** What names stand for (`Library.sourceOf`). */
export interface SourceNames {
  sourceOf(kind: Kind, name: string): string;
}

/** How far a face by its source is here, wearing these expressions: not yet, loaded, or shown in full. */
export type Arrival = (faces: readonly string[], expressions: readonly string[]) => "away" | "here" | "shown";

const SECONDS = 0.25;
/** Weight of what has come and is not drawn yet: so little of it shows that it may be drawn in full at once. */
const FIRST = 0.001;

/** A name on its way from what it stood for to what it stands for now. */
interface SourceChange {
  from: ReadonlyMap<string, number>;
  to: string;
  progress: number;
}

/**
 * Turns poses by name into poses by source. A name on air whose source changes passes from the old to the new in a
 * quarter of a second, once the new one is here; a name that is not on air changes at once.
 */
export class SourceCrossfade {
  private readonly changes: Record<Kind, Map<string, SourceChange>> = {
    faces: new Map(),
    expressions: new Map(),
    poses: new Map(),
  };

  constructor(private readonly sources: SourceNames) {}

  /** The pose by source, `seconds` after the last; `atOnce`: as the names stand now. */
  pose(pose: Pose, seconds: number, arrival: Arrival, atOnce = false): Pose {
    const faces = Object.keys(pose.faces);
    const expressions = expressionNames(pose);
    this.follow("faces", faces);
    this.follow("expressions", expressions);
    this.follow("poses", poseNames(pose));
    const worn = expressions.flatMap((name) => [...this.shares("expressions", name).keys()]);
    const wearing = faces.flatMap((name) => [...this.shares("faces", name).keys()]);
    for (const change of this.changes.faces.values())
      advance(change, seconds, atOnce ? "shown" : arrival([change.to], worn), atOnce);
    for (const change of this.changes.expressions.values())
      advance(change, seconds, atOnce ? "shown" : arrival(wearing, [change.to]), atOnce);
    for (const change of this.changes.poses.values()) advance(change, seconds, "shown", atOnce);
    return {
      ...pose,
      faces: this.spread("faces", pose.faces),
      expressions: this.spread("expressions", pose.expressions),
      regions: this.spreadRegions(pose.regions),
      channels: this.spread("expressions", pose.channels),
      added: this.spread("expressions", pose.added),
      figure: pose.figure && this.spreadFigure(pose.figure),
    };
  }

  /** What the names of a pose stand for now, and what they will. */
  wanted(kind: Kind, names: Iterable<string>): string[] {
    return [...names].flatMap((name) => [
      ...new Set([...this.shares(kind, name).keys(), this.sources.sourceOf(kind, name)]),
    ]);
  }

  /** Whether every name of the pose shows what it stands for now. */
  settled(pose: Pose): boolean {
    const rests = (kind: Kind, names: readonly string[]): boolean =>
      names.every((name) => {
        const change = this.changes[kind].get(name);
        return change === undefined || (change.progress === 1 && change.to === this.sources.sourceOf(kind, name));
      });
    return (
      rests("faces", Object.keys(pose.faces)) &&
      rests("expressions", expressionNames(pose)) &&
      rests("poses", poseNames(pose))
    );
  }

  /** Remembers what the names on air stand for, and forgets the others. */
  private follow(kind: Kind, names: readonly string[]): void {
    const changes = this.changes[kind];
    for (const name of changes.keys()) if (!names.includes(name)) changes.delete(name);
    for (const name of names) {
      const to = this.sources.sourceOf(kind, name);
      const change = changes.get(name);
      if (change === undefined || (change.to === name && to !== name && change.progress === 1))
        changes.set(name, { from: new Map(), to, progress: 1 }); // it was not on air, or nobody knew what it was
      else if (change.to !== to) changes.set(name, { from: sharesOf(change), to, progress: 0 });
    }
  }

  private shares(kind: Kind, name: string): ReadonlyMap<string, number> {
    const change = this.changes[kind].get(name);
    return change === undefined ? new Map([[this.sources.sourceOf(kind, name), 1]]) : sharesOf(change);
  }

  private spreadRegions(regions: Pose["regions"]): Pose["regions"] {
    const spread: Pose["regions"] = {};
    for (const region of Object.keys(regions) as (keyof Pose["regions"])[])
      spread[region] = this.spread("expressions", regions[region] ?? {});
    return spread;
  }

  /** What a figure does, its poses by source. */
  private spreadFigure(figure: FigureMix): FigureMix {
    const regions = Object.entries(figure.regions).map(([region, mix]) => [region, this.spread("poses", mix)] as const);
    return { ...figure, poses: this.spread("poses", figure.poses), regions: Object.fromEntries(regions) };
  }

  private spread(kind: Kind, weights: Weights): Weights {
    const spread: Weights = {};
    for (const name in weights)
      for (const [source, share] of this.shares(kind, name))
        spread[source] = (spread[source] ?? 0) + share * (weights[name] as number);
    return spread;
  }
}

/** The poses that a figure does, in the whole and in regions. */
function poseNames({ figure }: Pose): readonly string[] {
  if (!figure) return [];
  return [...new Set([figure.poses, ...Object.values(figure.regions)].flatMap((mix) => Object.keys(mix)))];
}

function advance(change: SourceChange, seconds: number, arrival: "away" | "here" | "shown", atOnce: boolean): void {
  if (change.progress === 1) return;
  if (atOnce) change.progress = 1;
  else if (arrival === "shown") change.progress = Math.min(1, change.progress + seconds / SECONDS);
  else if (arrival === "here") change.progress = Math.max(change.progress, Number.MIN_VALUE);
}

function sharesOf({ from, to, progress }: SourceChange): ReadonlyMap<string, number> {
  const share = progress === 0 ? 0 : progress === 1 ? 1 : Math.max(FIRST, MathUtils.smoothstep(progress, 0, 1));
  const shares = new Map([...from].map(([source, old]) => [source, old * (1 - share)]));
  if (share > 0) shares.set(to, (shares.get(to) ?? 0) + share);
  return new Map([...shares].filter(([, part]) => part > 0));
}
