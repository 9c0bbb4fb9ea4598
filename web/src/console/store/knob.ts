/** Values that hands can hold: channels, head, gaze and T-bars. */

import type { SKIN_FADERS, SPRINGS } from "../../link/constants";
import type { CharacterState, FromClient } from "../../link/messages";
import { faderOf, type LookKind } from "./axis";
import { handsOf } from "./held_state";
import { ECHO, HeldValues } from "./held_values";
import { influenceOf, type LayerName, type LayerPart } from "./layer_state";
import type { Outbox } from "./outbox";

/** One number under a hand. */
export interface Knob {
  readonly key: string;
  /** What messages that move it are told apart by, as in `Hands` behind the character. */
  readonly control: string;
  /** The value to show at `now`: the hand's own while it counts, else the server's. */
  value(now: number): number;
  /** The value that a step by key or wheel begins from at `now`: what was asked for last, until the server says another. */
  stepFrom(now: number): number;
  /** The hand holds the knob at `value`. */
  grip(value: number): void;
  /** One step by key or wheel. */
  nudge(value: number): void;
  leave(): void;
  /** A hand of this console is on the knob. */
  gripped(): boolean;
  /** A hand of this console is on the knob, also one that has lost it to a hand elsewhere. */
  touched(): boolean;
  /** The hand of this console counts at `now`: what moves then moves by it. */
  counts(now: number): boolean;
}

export type HeadPart = "yaw" | "pitch" | "roll";
export type GazePart = "yaw" | "pitch";
/** What is set of a character's automatic motion by hand. */
export type MotionDetail = "liveliness" | "blinks" | "gaze" | "breath";
export type SpringName = (typeof SPRINGS)[number];
export type SkinFader = (typeof SKIN_FADERS)[number];
/** As at first: nothing moves by itself. */
export const STILL: Readonly<Record<MotionDetail, number>> = { liveliness: 0, blinks: 1, gaze: 1, breath: 1 };
/** The dimensions of a pad, in order. */
export type PadAxis = "x" | "y" | "z";
export const PAD_AXES: readonly PadAxis[] = ["x", "y", "z"];
export const HEAD: readonly HeadPart[] = ["yaw", "pitch", "roll"];
export const GAZE: readonly GazePart[] = ["yaw", "pitch"];

/** What knobs need of their console. */
export interface KnobHost {
  /** What the character has on air whose values are shown. */
  air(): CharacterState | null;
  /** Whom messages are for. */
  targets(): readonly string[];
  /** Those of whom a macro is that are played. */
  withMacro(name: string): readonly string[];
  now(): number;
  /** Whether what moves a control can be sent; else the operator has been told. */
  mayAct(control: string): boolean;
}

export class Knobs {
  readonly #holds = new HeldValues<number>();
  /** When a hand of this console last moved what it holds, by key. */
  readonly #moved = new Map<string, number>();
  /** Keys that a hand of this console is on, also one that has lost the control to another. */
  readonly #touched = new Set<string>();

  constructor(
    private readonly host: KnobHost,
    private readonly outbox: Outbox,
  ) {}

  /** All hands off. */
  clear(): void {
    this.#holds.clear();
    this.#moved.clear();
    this.#touched.clear();
  }

  /** What the hands changed has been sent. */
  sent(): void {
    this.#holds.sent(this.host.now());
  }

  /** A hand elsewhere moves a control: one here that keeps still has lost it, until it moves again. */
  yieldTo(control: string): void {
    const now = this.host.now();
    for (const [key, moved] of this.#moved)
      if (controlOf(key) === control && now - moved > ECHO && this.#holds.gripped(key))
        this.#holds.leave(key, now - ECHO);
  }

  /** The weight of a channel; its mirror moves along where there is one. */
  channel(name: string, mirror: string | null): Knob {
    const names = mirror === null ? [name] : [name, mirror];
    return this.#knob(
      names.map((channel) => `channel:${channel}`),
      (state) => handsOf(state).channels[name] ?? 0,
      (value) => {
        for (const channel of names)
          this.#put(`channel:${channel}`, (character) => ({ type: "set_channel", character, name: channel, value }));
      },
    );
  }

  head(part: HeadPart): Knob {
    return this.#knob([`head:${part}`], (state) => handsOf(state).head[HEAD.indexOf(part)] ?? 0, this.#putHead);
  }

  gaze(part: GazePart): Knob {
    return this.#knob([`gaze:${part}`], (state) => handsOf(state).gaze[GAZE.indexOf(part)] ?? 0, this.#putGaze);
  }

  /** Where the point of a pad stands along one of its dimensions, -1..1. */
  pad(name: string, axis: PadAxis): Knob {
    return this.#knob(
      [`pad:${name}:${axis}`],
      (state) => state.pads[name]?.place[PAD_AXES.indexOf(axis)] ?? 0,
      () => this.#putPad(name),
    );
  }

  /** How much of a layer shows, in a part of the character or, `null`, on the whole. */
  layer(layer: LayerName, part: LayerPart | null): Knob {
    const key = part === null ? `layer:${layer}` : `layer:${layer}:${part}`;
    return this.#knob(
      [key],
      (state) => influenceOf(state, layer, part),
      (influence) => this.#put(key, (character) => ({ type: "set_layer", character, layer, region: part, influence })),
    );
  }

  /** How much the character moves by itself: on the whole, or one detail of it. */
  motion(detail: MotionDetail): Knob {
    const key = `motion:${detail}`;
    return this.#knob(
      [key],
      (state) => (state.motion ?? STILL)[detail],
      (value) => this.#put(key, (character) => ({ type: "set_motion", character, [detail]: value })),
    );
  }

  /** How much of a spring shows. */
  spring(name: SpringName): Knob {
    const key = `spring:${name}`;
    return this.#knob(
      [key],
      (state) => state.springs[name] ?? 1,
      (amount) => this.#put(key, (character) => ({ type: "set_spring", character, name, amount })),
    );
  }

  /** How much of what skin shows is seen. */
  skin(name: SkinFader): Knob {
    const key = `skin:${name}`;
    return this.#knob(
      [key],
      (state) => state.skin[name] ?? 1,
      (amount) => this.#put(key, (character) => ({ type: "set_skin", character, name, amount })),
    );
  }

  /** A macro: of each character that is played and has one of the name. */
  macro(name: string): Knob {
    const key = `macro:${name}`;
    return this.#knob(
      [key],
      (state) => state.macros[name]?.value ?? 0,
      (value) => {
        for (const character of this.host.withMacro(name))
          this.outbox.put(`${character}/${key}`, { type: "move_macro", character, name, value });
      },
    );
  }

  /** Where a T-bar stands, under the hand of this console or of another. */
  bar(axis: LookKind): Knob {
    const type = `fade_${axis}` as const;
    return this.#knob(
      [type],
      (state) => faderOf(state, axis),
      (value) => this.#put(type, (character) => ({ type, character, value })),
    );
  }

  readonly #putHead = (): void => {
    const [yaw, pitch, roll] = HEAD.map((part) => this.head(part).value(this.host.now())) as [number, number, number];
    this.#put("head", (character) => ({ type: "set_head", character, yaw, pitch, roll }));
  };

  readonly #putGaze = (): void => {
    const [yaw, pitch] = GAZE.map((part) => this.gaze(part).value(this.host.now())) as [number, number];
    this.#put("gaze", (character) => ({ type: "set_gaze", character, yaw, pitch }));
  };

  /** What hands elsewhere move of the same pad stays theirs: only the dimensions that are under a hand here go along. */
  #putPad(name: string): void {
    const now = this.host.now();
    const here = PAD_AXES.map((axis) => [axis, this.pad(name, axis)] as const).filter(([, knob]) => knob.counts(now));
    const place = Object.fromEntries(here.map(([axis, knob]) => [axis, knob.value(now)]));
    this.#put(`pad:${name}`, (character) => ({ type: "move_pad", character, name, ...place }));
  }

  /** Another has what a hand here is on: it shows what is on air. */
  #lose(keys: readonly string[]): void {
    for (const parameter of keys) this.#holds.leave(parameter, this.host.now() - ECHO);
  }

  /** A message for each character that is played. */
  #put(parameter: string, make: (character: string) => FromClient): void {
    for (const character of this.host.targets()) this.outbox.put(`${character}/${parameter}`, make(character));
  }

  #knob(keys: readonly string[], echo: (state: CharacterState) => number, put: (value: number) => void): Knob {
    const [key, host] = [keys[0] as string, this.host];
    const heard = (): number => {
      const state = host.air();
      return state === null ? 0 : echo(state);
    };
    return {
      key,
      control: controlOf(key),
      value: (now) => this.#holds.read(key, heard(), now),
      stepFrom: (now) => this.#holds.stepFrom(key, heard(), now),
      grip: (value) => {
        if (!host.mayAct(controlOf(key))) return this.#lose(keys);
        for (const parameter of keys) {
          this.#holds.grip(parameter, value);
          this.#moved.set(parameter, host.now());
          this.#touched.add(parameter);
        }
        put(value);
      },
      nudge: (value) => {
        if (!host.mayAct(controlOf(key))) return;
        for (const parameter of keys) this.#holds.nudge(parameter, value, host.now());
        put(value);
      },
      leave: () => {
        for (const parameter of keys) this.#holds.leave(parameter, host.now());
        for (const parameter of keys) this.#touched.delete(parameter);
      },
      touched: () => this.#touched.has(key),
      gripped: () => this.#holds.gripped(key),
      counts: (now) => this.#holds.counts(key, now),
    };
  }
}

/**
 * What `Hands` calls what a key stands for: `channel:jawOpen` is moved by `set_channel:jawOpen`, `layer:lips` by
 * `set_layer:lips`, `macro:mouth` by `move_macro:mouth`, `head:yaw` by `set_head`, `pad:moods:x` by `move_pad:moods`.
 */
function controlOf(key: string): string {
  const [what, name] = key.split(":");
  if (what === "pad") return `move_pad:${name}`;
  if (what === "channel" || what === "layer" || what === "spring" || what === "skin") return `set_${key}`;
  if (what === "macro") return `move_${key}`;
  return name === undefined ? key : `set_${what}`;
}
