/** What an operator does to layers and to what feeds them, each to be taken back where it can be. */

import { LAYER_PARTS, ROUTE_PARTS } from "../../link/constants";
import type { SourceState } from "../../link/messages";
import type { ConsoleStore } from "../store/console_store";
import { firstInfluence, type LayerName, layerOf } from "../store/layer_state";
import { sourceLabel } from "../store/source_label";
import type { Change } from "../store/undo_history";

/** Layer names as people read them. */
export const layerLabel = (layer: LayerName): string => `${layer[0]?.toUpperCase()}${layer.slice(1)}`;

/** How a source is read. */
export type Tuning = Pick<SourceState, "mirror" | "dead_zone" | "curve" | "gain" | "smoothing" | "lids">;
/** Whom a source drives, and on which layer. */
export type Route = Pick<SourceState, "characters" | "layer" | "regions">;

type RoutePart = SourceState["regions"][number];

/** The characters of a route after a press on one: in it or not any more. */
export const withCharacter = (characters: readonly string[], pressed: string, all: readonly string[]): string[] => {
  const now = characters.includes("*") ? all : characters;
  return now.includes(pressed) ? now.filter((other) => other !== pressed) : [...now, pressed];
};

/** The parts of a route after a press on one: of all this one alone, else in it or not any more; all where none is left. */
export const withPart = (parts: SourceState["regions"], pressed: RoutePart): SourceState["regions"] => {
  const every = ROUTE_PARTS.every((part) => parts.includes(part));
  const left = every ? [pressed] : ROUTE_PARTS.filter((part) => parts.includes(part) !== (part === pressed));
  return left.length === 0 ? [...ROUTE_PARTS] : left;
};

export class LayerCommands {
  constructor(private readonly store: ConsoleStore) {}

  /** Switches a layer of those that are played on or off, as the first of them is not. */
  switch(layer: LayerName): void {
    const { air } = this.store;
    if (air === null) return;
    const on = !layerOf(air, layer).on;
    const to = (wanted: (was: boolean) => boolean): Change[] =>
      this.#changesOfPlayed(([character, was]) => [{ type: "set_layer", character, layer, on: wanted(was) }], layer);
    this.store.act(`${layerLabel(layer)} is ${on ? "on" : "off"}.`, {
      what: `switch ${layer} ${on ? "on" : "off"}`,
      undo: to((was) => was),
      redo: to(() => on),
    });
  }

  /** The influence of a layer as it was at first, in every part. */
  reset(layer: LayerName): void {
    const to = (wanted: (influence: readonly number[]) => readonly number[]): Change[] =>
      this.#changesOfPlayed(
        ([character, , influence]) =>
          wanted(influence).map((value, at): Change => {
            return { type: "set_layer", character, layer, region: LAYER_PARTS[at] ?? null, influence: value };
          }),
        layer,
      );
    this.store.act(`${layerLabel(layer)} shows as at first.`, {
      what: `reset ${layer}`,
      undo: to((influence) => influence),
      redo: to(() => firstInfluence(layer)),
    });
  }

  /** Whom a source drives, on which layer. */
  route(source: SourceState, change: Partial<Route>): void {
    const to = ({ characters, layer, regions }: Route): Change[] => [
      { type: "route_source", source: source.name, characters, layer, regions },
    ];
    const does =
      change.layer !== undefined
        ? `drives ${change.layer} now`
        : change.regions !== undefined
          ? `plays ${change.regions.length === ROUTE_PARTS.length ? "all parts" : change.regions.join(", ")} now`
          : "drives others now";
    this.store.act(`${sourceLabel(source.name)} ${does}.`, {
      what: `route ${sourceLabel(source.name)}`,
      undo: to(source),
      redo: to({ ...source, ...change }),
    });
  }

  /** How a source is read. */
  tune(source: SourceState, change: Partial<Tuning>): void {
    const to = ({ mirror, dead_zone, curve, gain, smoothing, lids }: Tuning): Change[] => [
      { type: "tune_source", source: source.name, mirror, dead_zone, curve, gain, smoothing, lids },
    ];
    this.store.act(`${sourceLabel(source.name)} is read otherwise.`, {
      what: `tune ${sourceLabel(source.name)}`,
      undo: to(source),
      redo: to({ ...source, ...change }),
    });
  }

  /** Changes for each character that is played; its name, its switch and its influence are given. */
  #changesOfPlayed(make: (of: readonly [string, boolean, readonly number[]]) => Change[], layer: LayerName): Change[] {
    const characters = this.store.state?.characters ?? {};
    return this.store.played.names.flatMap((name) => {
      const character = characters[name];
      if (character === undefined) return [];
      const { on, influence } = layerOf(character, layer);
      return make([name, on, influence]);
    });
  }
}
