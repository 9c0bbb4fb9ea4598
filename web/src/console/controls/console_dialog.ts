/** A dialog over the console, which panic and what is on air stay beside. */

import { css } from "lit";
import { closeOutside, curtainBelowBar } from "../../ui/dialog_style";
import { layerWhileShown } from "../../ui/key_presses";
import { row } from "../../ui/theme";
import { stepOf } from "../store/keys";
import { ConsoleElement } from "./console_element";

/**
 * Closed by Escape, by a press beside it or by a button; its `first` element gets the focus. What is changed in one that
 * `takesBack` is taken back by the keys of the page; no key works through others. Tells `close`.
 */
export abstract class ConsoleDialog extends ConsoleElement {
  protected readonly first: string = "button";
  protected readonly takesBack: boolean = false;

  constructor() {
    super();
    closeOutside(this, this.close);
    layerWhileShown(this, "dialog", this.close, this.#hears);
  }

  readonly #hears = (event: KeyboardEvent): boolean => {
    const step = this.takesBack ? stepOf(event) : null;
    if (step !== null && !event.repeat) this.store[step]();
    return step !== null;
  };

  override firstUpdated(): void {
    this.renderRoot.querySelector<HTMLElement>(this.first)?.focus();
  }
}

/** A sheet in the middle of the page, as wide as its own style says. */
export const sheet = css`
  ${curtainBelowBar}
  ${row}
  section {
    display: grid;
    gap: 10px;
    max-height: 100%;
    overflow: auto;
    padding: 16px 18px;
  }
  p {
    color: var(--dim);
  }
`;
