/** The steps of a T-bar by key or wheel: its first one is never dead, whichever end the call runs from. */

import { UNIT, within } from "../../ui/travel";
import type { BarView } from "./t_bar_view";

export class BarKeys {
  #target: string | null = null;
  #turned = false;

  /**
   * The position that a step by `by` from `position` leads to. Where a call begins at the end that a key points to, that
   * key leads on all the same, and the other one back, until another call comes.
   */
  step({ target, flipped }: Pick<BarView, "target" | "flipped">, position: number, by: number): number {
    if (target !== this.#target) this.#turned = false;
    this.#target = target;
    const start = flipped ? 1 : 0;
    if (target !== null && position === start && this.#reach(position, by) === position) this.#turned = !this.#turned;
    return this.#reach(position, by);
  }

  #reach(position: number, by: number): number {
    return within(position + (this.#turned ? -by : by), UNIT);
  }
}
