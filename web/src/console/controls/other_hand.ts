/** The mark on a control that a hand at another console moves: the name of that console. */

import { css } from "lit";
import { ellipsis } from "../../ui/theme";
import type { ConsoleStore } from "../store/console_store";
import type { Knob } from "../store/knob";
import type { StyleWriter } from "./console_element";

export const otherStyle = css`
  .other {
    position: absolute;
    z-index: 1;
    inset: 2px 2px auto auto;
    max-width: calc(100% - 4px);
    max-height: calc(100% - 4px);
    padding: 1px 4px;
    border-radius: 3px;
    font-size: 11px;
    font-weight: 600;
    line-height: 14px;
    ${ellipsis}
    color: var(--text);
    background: var(--edge);
    pointer-events: none;
  }
  .other:empty {
    display: none;
  }
  .slot .other,
  .track .other {
    padding: 4px 0;
    writing-mode: vertical-rl;
  }
  .other.contested {
    color: #000;
    background: var(--attention);
  }
`;

/** Writes whose hand is on a knob; it wants attention where a hand of this console is on it too. */
export function paintOther(write: StyleWriter, mark: HTMLElement, store: ConsoleStore, knob: Knob, now: number): void {
  const other = store.otherOn(knob) ?? "";
  write.text(mark, other);
  write.flag(mark, "contested", other !== "" && (knob.touched() || knob.counts(now)));
}
