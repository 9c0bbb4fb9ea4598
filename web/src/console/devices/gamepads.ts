/** Gamepads and joysticks at this browser (Gamepad API), looked at again and again: the browser tells of no change. */

import type { DeviceNames } from "./device_names";
import type { DeviceEvents } from "./midi_ports";

/** What is read of a gamepad. */
export interface PadState {
  readonly id: string;
  readonly index: number;
  readonly connected: boolean;
  readonly mapping: string;
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly value: number; readonly pressed: boolean }[];
}

interface KnownPad {
  readonly device: string;
  readonly id: string;
  readonly values: Map<string, number>;
}

/** Space mice, which some systems list as a gamepad with six axes. */
const SPACE_MOUSE = /space\s?(mouse|navigator|pilot|explorer|ball|traveler)|3dconnexion|\b256f\b/i;
/** The names of a space mouse's axes, in the order in which it is listed. */
export const SPACE_AXES = ["x", "y", "z", "rx", "ry", "rz"] as const;
/** Where the standard mapping has the two triggers, which are levels too. */
const TRIGGERS: readonly number[] = [6, 7];
const STANDARD = "standard";

export class Gamepads {
  readonly #pads = new Map<number, KnownPad>();

  /** `listed`: the browser's list; `passed`: those that another interface has already. */
  constructor(
    private readonly names: DeviceNames,
    private readonly events: DeviceEvents,
    private readonly moved: (device: string, values: Record<string, number>) => void,
    private readonly listed: () => readonly (PadState | null)[],
    private readonly passed: (pad: PadState) => boolean = () => false,
  ) {}

  /** Looks once: who came, who went, and what moved. */
  look(): void {
    const pads = [...this.listed()].filter((pad) => pad?.connected && !this.passed(pad)) as PadState[];
    for (const [index, knownPad] of this.#pads)
      if (!pads.some((pad) => pad.index === index && pad.id === knownPad.id)) this.#leave(index, knownPad);
    for (const pad of pads) {
      const knownPad = this.#pads.get(pad.index);
      if (knownPad === undefined) this.#take(pad);
      else this.#follow(pad, knownPad);
    }
  }

  /** Lets go of all of them. */
  close(): void {
    for (const [index, knownPad] of this.#pads) this.#leave(index, knownPad);
  }

  /** A pad is here: where its controls stand now is where they rest, and plays nothing. */
  #take(pad: PadState): void {
    const device = this.names.take(keyOf(pad), pad.id);
    this.#pads.set(pad.index, { device, id: pad.id, values: new Map(valuesOf(pad)) });
    this.events.plugged(device, isSpaceMouse(pad) ? "space_mouse" : "gamepad");
  }

  #follow(pad: PadState, { device, values }: KnownPad): void {
    const changed = valuesOf(pad).filter(([control, value]) => values.get(control) !== value);
    if (changed.length === 0) return;
    for (const [control, value] of changed) values.set(control, value);
    this.moved(device, Object.fromEntries(changed));
  }

  #leave(index: number, { device, id }: KnownPad): void {
    this.#pads.delete(index);
    this.names.leave(keyOf({ id, index }));
    this.events.unplugged(device);
  }
}

export const isSpaceMouse = (pad: Pick<PadState, "id" | "axes">): boolean =>
  pad.axes.length >= SPACE_AXES.length && SPACE_MOUSE.test(pad.id);

const keyOf = ({ id, index }: Pick<PadState, "id" | "index">): string => `gamepad ${id} ${index}`;

/** Where each control stands, 0 to 1; an axis rests at one half. */
function valuesOf(pad: PadState): [string, number][] {
  const named = isSpaceMouse(pad) ? SPACE_AXES : [];
  const axes = pad.axes.map((value, index) => [named[index] ?? `axis${index}`, unit((value + 1) / 2)] as const);
  const buttons = pad.buttons.map(({ value }, index) => [`button${index}`, unit(value)] as const);
  const triggers = pad.mapping === STANDARD ? TRIGGERS.filter((index) => index < pad.buttons.length) : [];
  const levels = triggers.map((index) => [`trigger${index}`, unit(pad.buttons[index]?.value ?? 0)] as const);
  return [...axes, ...buttons, ...levels]
    .filter(([, value]) => !Number.isNaN(value))
    .map(([name, value]) => [name, value]);
}

/** Drivers give a little more than their range at an end. */
const unit = (value: number): number => Math.max(0, Math.min(1, value));
