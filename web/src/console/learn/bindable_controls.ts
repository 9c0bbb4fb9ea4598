/** The controls of the page that a device can play: which there are, where they are seen, and what each plays. */

import type { BindingDocument } from "../../link/messages";
import { CHANNEL, fractionOf, type Range, UNIT } from "../../ui/travel";
import type { Fader } from "../controls/fader";
import type { Pad } from "../controls/pad";
import type { TBar } from "../controls/t_bar";
import {
  BACK_TARGET,
  BLACK_TARGET,
  barTarget,
  bindingsByTarget,
  callTarget,
  channelTarget,
  characterOf,
  clipTarget,
  directionTarget,
  GO_TARGET,
  layerTarget,
  lightTarget,
  macroTarget,
  memoryTarget,
  padTarget,
  panicTarget,
  stopClipsTarget,
  type Target,
  targetKey,
  whoOf,
} from "../devices/binding_target";
import type { MacroFader } from "../mappings/macro_fader";
import type { LayerFader } from "../mixer/layer_fader";
import type { BlendPad } from "../pads/blend_pad";
import type { Palette } from "../palette/palette";
import type { ConsoleStore } from "../store/console_store";
import type { PadAxis } from "../store/knob";

export interface BindableControl {
  readonly element: HTMLElement;
  /** What it plays; of a pad one target for each of its axes. */
  readonly targets: readonly Target[];
  /** The range of an upright fader, on which a second mark can stand; null for all else. */
  readonly travel: Range | null;
}

/** Where something is seen, in pixels of the page. */
export interface PageBox {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

type BindablePart = readonly [selector: string, read: (part: HTMLElement) => readonly Target[], travel?: Range];

/** What of an element of the console can be bound, by its tag. */
const PARTS: Readonly<Record<string, (element: Element, store: ConsoleStore, who: string) => readonly BindablePart[]>> =
  {
    "omote-fader": (element, _, who) => [[".slot", () => [channelTarget(who, (element as Fader).channel)], CHANNEL]],
    "omote-macro-fader": (element, _, who) => {
      const { name, range } = element as MacroFader;
      return [[".slot", () => [macroTarget(who, name)], range]];
    },
    "omote-tbar": (element, _, who) => [[".track", () => [barTarget(who, (element as TBar).axis)], UNIT]],
    "omote-layer-fader": (element, _, who) => {
      const { layer, region } = element as LayerFader;
      return [[".slot", () => [layerTarget(who, layer, region)], UNIT]];
    },
    "omote-pad": (element, _, who) => {
      const { what } = element as Pad;
      const turns = (...parts: string[]) => parts.map((part) => directionTarget(who, what, part));
      return [
        [".field", () => turns("yaw", "pitch")],
        [".tilt", () => turns("roll")],
      ];
    },
    "omote-blend-pad": (element, _, who) => {
      const { pad, axes } = element as BlendPad;
      const along = (...of: PadAxis[]) => of.map((axis) => padTarget(who, pad.name, axis));
      return [
        [".field", () => along(...axes.slice(0, 2))],
        [".depth", () => along("z")],
      ];
    },
    "omote-palette": (element, store, who) => {
      const { axis } = element as Palette;
      return [[".tile", (tile) => [callTarget(who, axis, tile.dataset.name ?? "", store.callSeconds(axis))]]];
    },
    "omote-clip-tiles": (_, __, who) => [
      ["[data-name]", (tile) => [clipTarget(who, tile.dataset.name ?? "")]],
      [".stop", () => [stopClipsTarget(who)]],
    ],
    "omote-lights": (_, store) => [
      ["[data-light]", (key) => [lightTarget(key.dataset.light ?? "", store.timing.face.seconds)]],
      [".black", () => [BLACK_TARGET]],
    ],
    "omote-black-key": () => [["button", () => [BLACK_TARGET]]],
    "omote-next-cue": () => [
      [".go", () => [GO_TARGET]],
      [".back", () => [BACK_TARGET]],
    ],
    "omote-memories": (_, store) => [
      ["[data-memory]", (key) => [memoryTarget(key.dataset.memory ?? "", store.timing.face.seconds)]],
    ],
  };
const TAGS = Object.keys(PARTS).join(",");
/** Elements that hold others of these. */
const HOLDERS = "omote-bank,omote-layer-panel,omote-pad-panel";

/** All of them below a root, in the order of the page. */
export function findControls(root: ParentNode, store: ConsoleStore): BindableControl[] {
  const who = whoOf(store.played.targets);
  const controls: BindableControl[] = [];
  for (const element of root.querySelectorAll(`${TAGS},${HOLDERS}`)) {
    const inside = element.shadowRoot;
    const parts = PARTS[element.localName];
    if (inside === null) continue;
    for (const [selector, read, travel = null] of parts?.(element, store, who) ?? [])
      for (const part of inside.querySelectorAll<HTMLElement>(selector))
        controls.push({ element: part, targets: read(part), travel });
    controls.push(...findControls(inside, store));
  }
  return controls;
}

/** The key that is panic, which no touch learns: it is pressed at any time. */
export function findPanic(root: ParentNode, store: ConsoleStore): BindableControl[] {
  const targets = [panicTarget(whoOf(store.played.targets))];
  const roots = [root, ...[...root.querySelectorAll("omote-status")].flatMap(({ shadowRoot }) => shadowRoot ?? [])];
  return roots.flatMap((each) =>
    [...each.querySelectorAll<HTMLElement>(".panic:not(.all)")].map((element) => ({ element, targets, travel: null })),
  );
}

/** The bindings of each target as `targetKey` has it: one of all characters plays the controls of those played here. */
export function bindingsShown(
  bindings: readonly BindingDocument[],
  store: ConsoleStore,
): ReturnType<typeof bindingsByTarget> {
  const { names, targets } = store.played;
  return bindingsByTarget(bindings, (binding) => {
    const who = characterOf(binding.to);
    const here = who === "*" || names.includes(who);
    return targetKey(here ? { ...binding, to: binding.to.replace(`/${who}/`, `/${whoOf(targets)}/`) } : binding);
  });
}

/** The part of a control that is seen: what scrolls out of its panel is not; null for nothing of it. */
export function seenBox(element: HTMLElement): PageBox | null {
  let { left, top, right, bottom } = element.getBoundingClientRect();
  for (const frame of framesOf(element)) {
    const edge = frame.getBoundingClientRect();
    left = Math.max(left, edge.left);
    top = Math.max(top, edge.top);
    right = Math.min(right, edge.right);
    bottom = Math.min(bottom, edge.bottom);
  }
  return right - left > SEEN && bottom - top > SEEN ? { left, top, right, bottom } : null;
}

/** Pixels of a control that count as something of it. */
const SEEN = 6;
const frames = new WeakMap<Element, readonly Element[]>();

/** What a control can scroll out of: it stays the same, so it is looked up once. */
function framesOf(element: Element): readonly Element[] {
  const cached = frames.get(element);
  if (cached !== undefined) return cached;
  const clipping: Element[] = [];
  for (let ancestor = parentOf(element); ancestor !== null; ancestor = parentOf(ancestor))
    if (getComputedStyle(ancestor).overflow !== "visible") clipping.push(ancestor);
  frames.set(element, clipping);
  return clipping;
}

function parentOf(element: Element): Element | null {
  if (element.parentElement !== null) return element.parentElement;
  const root = element.getRootNode();
  return root instanceof ShadowRoot ? root.host : null;
}

/** How far up a fader's mark stands, in parts of the fader. */
export const markHeight = (value: number, travel: Range): number => Math.max(0, Math.min(1, fractionOf(value, travel)));
