/** Values that hands can hold: channels, head, gaze and T-bars. */

import type { FromClient, State } from "../../link/messages";
import type { Axis } from "./axis";
import { ECHO, HeldValues } from "./held_values";
import type { Outbox } from "./outbox";

/** One number under a hand. */
export interface Knob {
  readonly key: string;
  /** What messages that move it are told apart by, as in `Hands`. */
  readonly control: string;
  /** The value to show at `now`: the hand's own while it counts, else the server's. */
  value(now: number): number;
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
export const HEAD: readonly HeadPart[] = ["yaw", "pitch", "roll"];
export const GAZE: readonly GazePart[] = ["yaw", "pitch"];

/** What knobs need of their console. */
export interface KnobHost {
  state(): State | null;
  now(): number;
  /** Whether anything can be sent; else the operator has been told. */
  mayAct(): boolean;
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
      names.map((one) => `channel:${one}`),
      (state) => state.channels[name] ?? 0,
      (value) => {
        for (const one of names) this.outbox.put(`channel:${one}`, { type: "set_channel", name: one, value });
      },
    );
  }

  head(part: HeadPart): Knob {
    return this.#knob([`head:${part}`], (state) => state.head[HEAD.indexOf(part)] ?? 0, this.#putHead);
  }

  gaze(part: GazePart): Knob {
    return this.#knob([`gaze:${part}`], (state) => state.gaze[GAZE.indexOf(part)] ?? 0, this.#putGaze);
  }

  /** Where a T-bar stands, under the hand of this console or of another. */
  bar(axis: Axis): Knob {
    const type = axis === "face" ? "fade_face" : "fade_expression";
    return this.#knob(
      [type],
      (state) => state[axis === "face" ? "face_fader" : "expression_fader"],
      (value) => this.outbox.put(type, { type, value }),
    );
  }

  readonly #putHead = (): void => {
    const [yaw, pitch, roll] = HEAD.map((part) => this.head(part).value(this.host.now())) as [number, number, number];
    this.outbox.put("head", { type: "set_head", yaw, pitch, roll } satisfies FromClient);
  };

  readonly #putGaze = (): void => {
    const [yaw, pitch] = GAZE.map((part) => this.gaze(part).value(this.host.now())) as [number, number];
    this.outbox.put("gaze", { type: "set_gaze", yaw, pitch } satisfies FromClient);
  };

  #knob(keys: readonly string[], echo: (state: State) => number, put: (value: number) => void): Knob {
    const [key, host] = [keys[0] as string, this.host];
    const heard = (): number => {
      const state = host.state();
      return state === null ? 0 : echo(state);
    };
    return {
      key,
      control: controlOf(key),
      value: (now) => this.#holds.read(key, heard(), now),
      grip: (value) => {
        if (!host.mayAct()) return;
        for (const one of keys) {
          this.#holds.grip(one, value);
          this.#moved.set(one, host.now());
          this.#touched.add(one);
        }
        put(value);
      },
      nudge: (value) => {
        if (!host.mayAct()) return;
        for (const one of keys) this.#holds.nudge(one, value, host.now());
        put(value);
      },
      leave: () => {
        for (const one of keys) this.#holds.leave(one, host.now());
        for (const one of keys) this.#touched.delete(one);
      },
      touched: () => this.#touched.has(key),
      gripped: () => this.#holds.gripped(key),
      counts: (now) => this.#holds.counts(key, now),
    };
  }
}

/** What `Hands` calls what a key stands for: `channel:jawOpen` is moved by `set_channel:jawOpen`, `head:yaw` by `set_head`. */
function controlOf(key: string): string {
  const [what, name] = key.split(":");
  if (what === "channel") return `set_channel:${name}`;
  return name === undefined ? key : `set_${what}`;
}
