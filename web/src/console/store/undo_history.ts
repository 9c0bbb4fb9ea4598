/** What this console has done that can be taken back, and what was taken back and can be done again, step by step. */

export type Way = "undo" | "redo";

/** Takes a step in one way; whether it was done, or sent. Calls `refused` where the show rejects it later. */
export type TakeStep = (refused: (reason: string) => void) => boolean;

/** Something done: what, for people, and both ways. */
export interface Step {
  readonly what: string;
  readonly undo: TakeStep;
  readonly redo: TakeStep;
}

/** Steps that are remembered. */
export const MOST_STEPS = 100;

export class UndoHistory {
  readonly #steps: Record<Way, Step[]> = { undo: [], redo: [] };

  /** `refused`: told of a step that the show rejected, which is where it was before. */
  constructor(private readonly refused: (step: Step, way: Way, reason: string) => void) {}

  /** Something was done: what was taken back before cannot be done again. */
  add(step: Step): void {
    this.#steps.undo = [...this.#steps.undo, step].slice(-MOST_STEPS);
    this.#steps.redo = [];
  }

  /** The step that is next in a way, null for none. */
  next(way: Way): Step | null {
    return this.#steps[way].at(-1) ?? null;
  }

  /** Takes the next step; null where there is none or it was not sent. */
  take(way: Way): Step | null {
    const step = this.next(way);
    const back = way === "undo" ? "redo" : "undo";
    if (step === null || !step[way]((reason) => this.#return(step, back, reason))) return null;
    this.skip(step);
    this.#steps[back].push(step);
    return step;
  }

  /** Leaves a step out for good: those before it can be taken. */
  skip(step: Step): void {
    for (const way of ["undo", "redo"] as const) this.#steps[way] = this.#steps[way].filter((one) => one !== step);
  }

  /** Puts a step back that was rejected. */
  #return(step: Step, from: Way, reason: string): void {
    if (!this.#steps[from].includes(step)) return;
    const way = from === "undo" ? "redo" : "undo";
    this.skip(step);
    this.#steps[way].push(step);
    this.refused(step, way, reason);
  }
}
