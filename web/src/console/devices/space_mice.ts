/** Space mice at this browser, read as they are (WebHID): six axes and their buttons. */

import type { DeviceNames } from "./device_names";
import { SPACE_AXES } from "./gamepads";
import type { DeviceEvents } from "./midi_ports";

/** What is used of WebHID, which TypeScript does not know. */
export interface HidDevice extends EventTarget {
  readonly opened: boolean;
  readonly productName: string;
  readonly vendorId: number;
  readonly productId: number;
  open(): Promise<void>;
  close(): Promise<void>;
}

export interface Hid extends EventTarget {
  getDevices(): Promise<HidDevice[]>;
  requestDevice(options: { filters: readonly object[] }): Promise<HidDevice[]>;
}

export interface HidReport {
  readonly reportId: number;
  readonly data: DataView;
}

/** The usage of a device with several axes (generic desktop, multi-axis controller), which all space mice have. */
export const SPACE_MICE: readonly object[] = [{ usagePage: 0x01, usage: 0x08 }];
/** Counts of an axis that is pushed to its end. */
const FULL = 350;
const MOVE = 1;
const TURN = 2;
const BUTTONS = 3;

/** Where the controls stand that a report tells of, 0 to 1; an axis rests at one half. */
export function readReport({ reportId, data }: HidReport): Record<string, number> {
  if (reportId === BUTTONS) return readButtons(data);
  if (reportId !== MOVE && reportId !== TURN) return {};
  const first = reportId === TURN ? 3 : 0;
  const names = SPACE_AXES.slice(first, first + Math.floor(data.byteLength / 2)); // newer ones send all six at once
  return Object.fromEntries(names.map((name, index) => [name, positionOf(data.getInt16(2 * index, true))]));
}

function readButtons(data: DataView): Record<string, number> {
  const buttons: Record<string, number> = {};
  for (let index = 0; index < Math.min(4, data.byteLength) * 8; index += 1)
    buttons[`button${index}`] = (data.getUint8(index >> 3) >> (index & 7)) & 1;
  return buttons;
}

/** Some give more than the full count where they are pushed hard. */
const positionOf = (count: number): number => (Math.max(-1, Math.min(1, count / FULL)) + 1) / 2;

interface Opened {
  readonly device: string;
  readonly values: Map<string, number>;
  readonly changed: Map<string, number>;
  readonly ending: AbortController;
}

export class SpaceMice {
  readonly #opened = new Map<HidDevice, Opened>();

  constructor(
    private readonly names: DeviceNames,
    private readonly events: DeviceEvents,
    private readonly moved: (device: string, values: Record<string, number>) => void,
    private readonly hid: Hid,
  ) {
    hid.addEventListener("connect", () => void this.open());
    hid.addEventListener("disconnect", (event) => this.#leave((event as Event & { device: HidDevice }).device));
  }

  /** Whether a device with these numbers is read here. */
  has(numbers: string): boolean {
    return [...this.#opened.keys()].some(({ vendorId, productId }) =>
      numbers.includes(`${hex(vendorId)}:${hex(productId)}`),
    );
  }

  /** Reads all that the browser lets this page have. */
  async open(): Promise<number> {
    const mice = await this.hid.getDevices();
    await Promise.all(mice.map((mouse) => this.#take(mouse)));
    return this.#opened.size;
  }

  /** Lets the operator choose one. */
  async ask(): Promise<number> {
    await this.hid.requestDevice({ filters: SPACE_MICE });
    return this.open();
  }

  /** Tells what has moved since the last time. */
  look(): void {
    for (const { device, changed } of this.#opened.values()) {
      if (changed.size === 0) continue;
      this.moved(device, Object.fromEntries(changed));
      changed.clear();
    }
  }

  /** Lets go of all of them. */
  close(): void {
    for (const mouse of [...this.#opened.keys()]) {
      this.#leave(mouse);
      void mouse.close();
    }
  }

  async #take(mouse: HidDevice): Promise<void> {
    if (this.#opened.has(mouse)) return;
    if (!mouse.opened) await mouse.open();
    const device = this.names.take(keyOf(mouse), mouse.productName);
    const opened: Opened = { device, values: new Map(), changed: new Map(), ending: new AbortController() };
    this.#opened.set(mouse, opened);
    const hear = (event: Event): void => this.#hear(opened, event as Event & HidReport);
    mouse.addEventListener("inputreport", hear, { signal: opened.ending.signal });
    this.events.plugged(device, "space_mouse");
  }

  #hear({ values, changed }: Opened, report: HidReport): void {
    const key = report.reportId === BUTTONS;
    for (const [control, value] of Object.entries(readReport(report))) {
      if ((values.get(control) ?? (key ? 0 : 0.5)) !== value) changed.set(control, value);
      values.set(control, value);
    }
    if (key) this.look(); // a short press must not be gone before the next look
  }

  #leave(mouse: HidDevice): void {
    const opened = this.#opened.get(mouse);
    if (opened === undefined) return;
    opened.ending.abort();
    this.#opened.delete(mouse);
    this.names.leave(keyOf(mouse));
    this.events.unplugged(opened.device);
  }
}

const hex = (number: number): string => number.toString(16).padStart(4, "0");
const keyOf = ({ vendorId, productId, productName }: HidDevice): string =>
  `hid ${hex(vendorId)}:${hex(productId)} ${productName}`;
