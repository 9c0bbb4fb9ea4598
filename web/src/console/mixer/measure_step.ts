/** A measure of a performer as a step that can be taken back and done again: known when the show tells it. */

import type { SourceState } from "../../link/messages";
import { sourceLabel } from "../store/source_label";
import type { Step } from "../store/undo_history";

type Measured = Pick<SourceState, "name" | "neutral" | "highest">;

/** Measures that were asked for, until the show tells what they found. */
export class MeasureSteps {
  readonly #before = new Map<string, Measured>();

  /** A measure of a source is asked for, which has this one now. */
  ask(source: Measured): void {
    this.#before.set(source.name, source);
  }

  /** The steps of the measures that were asked for and that the show has told since. */
  receive(sources: readonly Measured[]): Step[] {
    return sources.flatMap((after) => {
      const before = this.#before.get(after.name);
      if (before === undefined || same(before, after)) return [];
      this.#before.delete(after.name);
      return [{ what: `measure ${sourceLabel(after.name)}`, undo: [measureOf(before)], redo: [measureOf(after)] }];
    });
  }
}

const measureOf = ({ name, neutral, highest }: Measured) =>
  ({ type: "measure_source", source: name, neutral, highest }) as const;

const same = (measured: Measured, other: Measured): boolean =>
  JSON.stringify([measured.neutral, measured.highest]) === JSON.stringify([other.neutral, other.highest]);
