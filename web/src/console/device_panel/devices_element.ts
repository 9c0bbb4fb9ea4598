/** What every part of the devices panel has: the stores that it shows, and the animation frame. */

import { css, LitElement } from "lit";
import { property } from "lit/decorators.js";
import type { FramePainter, Paintable } from "../../ui/frame_painter";
import type { ConsoleDevices } from "../devices/console_devices";
import type { ConsoleStore } from "../store/console_store";

export interface DevicesContext {
  readonly store: ConsoleStore;
  readonly devices: ConsoleDevices;
  readonly painter: FramePainter;
}

export abstract class DevicesElement extends LitElement implements Paintable {
  @property({ attribute: false }) context!: DevicesContext;
  #leave: (() => void)[] = [];

  get store(): ConsoleStore {
    return this.context.store;
  }

  get devices(): ConsoleDevices["store"] {
    return this.context.devices.store;
  }

  /** Listens to what it renders again for; gives what ends each. */
  protected abstract listen(changed: () => void): (() => void)[];

  /** Writes what moves. */
  paint(): void {}

  override connectedCallback(): void {
    super.connectedCallback();
    this.#leave = this.listen(() => this.requestUpdate());
    void this.updateComplete.then(() => this.isConnected && this.context.painter.add(this));
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const leave of this.#leave) leave();
    this.context.painter.delete(this);
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
  .row {
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    gap: 6px;
  }
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
