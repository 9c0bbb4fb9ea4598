/** What every part of the devices panel has: the stores that it shows, and the animation frame. */

import { css } from "lit";
import { row } from "../../ui/theme";
import { AnimatedElement, type ConsoleContext } from "../controls/console_element";
import type { Topic } from "../store/page_store";
import type { ConsoleDevices } from "./console_devices";

/** What the page of devices has, and the console too. */
export type DevicesContext = Pick<ConsoleContext, "store" | "devices" | "painter">;

export abstract class DevicesElement extends AnimatedElement<DevicesContext> {
  get devices(): ConsoleDevices {
    return this.context.devices;
  }

  /** Writes what moves. */
  paint(): void {}

  #shape = "";

  /** What it shows of what comes many times a second: it renders again where this is another. */
  protected shape(): unknown {
    return null;
  }

  protected override changed(topic: Topic): void {
    const shape = JSON.stringify(this.shape());
    if (topic !== "devices" || shape !== this.#shape) super.changed(topic);
    this.#shape = shape;
  }
}

/** The look of a section of the panel. */
export const section = css`
  h2 {
    margin: 0 0 6px;
  }
  p {
    margin: 0 0 8px;
    max-width: 70ch;
    color: var(--dim);
  }
  ${row}
  .attention {
    color: var(--attention);
  }
  .lamp {
    flex: none;
    width: 9px;
    height: 9px;
    border-radius: 50%;
    border: 1px solid var(--edge);
  }
  .lamp.on {
    border-color: var(--text);
    background: var(--text);
  }
  @media (pointer: coarse) {
    button,
    select,
    input:not([type="checkbox"]) {
      min-height: 44px;
    }
  }
`;
