/** What this console has done that can be taken back, and what was taken back and can be done again, step by step. */

import type { FromClient } from "../../link/messages";
import type { Asked } from "./requests";

export type Way = "undo" | "redo";

/** What a step sends: plain data, so that it outlives a reload of the page. */
export type Change = Asked | Extract<FromClient, { type: "set_home" | "set_channel" }>;

/** Something done: what, for people, and what is sent in both ways. */
export interface Step {
  readonly what: string;
  readonly undo: readonly Change[];
  readonly redo: readonly Change[];
  /** The panics there had been: after another one it is not taken back. */
  readonly panics?: number;
}

/** The step that puts channels to rest; `before`: the character, the name and the weight of each. */
export function clearStep(before: readonly (readonly [string, string, number])[]): Step {
  const to = (at: (weight: number) => number): Change[] =>
    before.map(([character, name, weight]) => ({ type: "set_channel", character, name, value: at(weight) }));
  const what = `clear ${before.length} ${before.length === 1 ? "fader" : "faders"}`;
  return { what, undo: to((weight) => weight), redo: to(() => 0) };
}

/** The characters whose channels a step moves. */
export const movedBy = (step: Step): string[] => [
  ...new Set(step.undo.flatMap((change) => (change.type === "set_channel" ? [change.character] : []))),
];

/** Takes a step in one way; whether it was sent. Calls `refused` where the show rejects it later. */
export type TakeStep = (step: Step, way: Way, refused: (reason: string) => void) => boolean;

/** What can be taken in both ways, the next one last. */
export type Steps = Readonly<Record<Way, readonly Step[]>>;

/** Steps that are remembered. */
export const MOST_STEPS = 100;

export class UndoHistory {
  #steps: Steps = { undo: [], redo: [] };

  /** `refused`: told of a step that the show rejected, which is where it was before; `changed`: after each change. */
  constructor(
    private readonly send: TakeStep,
    private readonly refused: (step: Step, way: Way, reason: string) => void,
    private readonly changed: () => void = () => undefined,
  ) {}

  get steps(): Steps {
    return this.#steps;
  }

  /** Goes on from the steps of before a reload. */
  resume(steps: Steps): void {
    this.#put(steps.undo, steps.redo);
  }

  /** Something was done: what was taken back before cannot be done again. */
  add(step: Step): void {
    this.#put([...this.#steps.undo, step], []);
  }

  /** The step that is next in a way, null for none. */
  next(way: Way): Step | null {
    return this.#steps[way].at(-1) ?? null;
  }

  /** Takes the next step; null where there is none or it was not sent. */
  take(way: Way): Step | null {
    const step = this.next(way);
    const back = way === "undo" ? "redo" : "undo";
    if (step === null || !this.send(step, way, (reason) => this.#return(step, back, reason))) return null;
    this.#move(step, back);
    return step;
  }

  /** Leaves a step out for good: those before it can be taken. */
  skip(step: Step): void {
    const others = (way: Way): readonly Step[] => this.#steps[way].filter((other) => other !== step);
    this.#put(others("undo"), others("redo"));
  }

  /** Puts a step back that was rejected. */
  #return(step: Step, from: Way, reason: string): void {
    if (!this.#steps[from].includes(step)) return;
    const way = from === "undo" ? "redo" : "undo";
    this.#move(step, way);
    this.refused(step, way, reason);
  }

  #move(step: Step, to: Way): void {
    this.skip(step);
    const { undo, redo } = this.#steps;
    this.#put(to === "undo" ? [...undo, step] : undo, to === "redo" ? [...redo, step] : redo);
  }

  #put(undo: readonly Step[], redo: readonly Step[]): void {
    this.#steps = { undo: undo.slice(-MOST_STEPS), redo: redo.slice(-MOST_STEPS) };
    this.changed();
  }
}
