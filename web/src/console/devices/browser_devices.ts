/** The devices at this browser, told to the show: which there are, what they send, and what the browser lets us have. */

import type { DeviceState, FromClient, Refused } from "../../link/messages";
import { type BrowserStorage, keep, readKept, readRecord } from "../../ui/browser_storage";
import type { ConsoleStore } from "../store/console_store";
import { ByteBatches } from "./byte_batches";
import { DeviceNames } from "./device_names";
import { Gamepads, type PadState } from "./gamepads";
import { type DeviceKind, MidiPorts } from "./midi_ports";
import { type Hid, SpaceMice } from "./space_mice";

/** What a browser offers; what it has not is left out. `secure`: https, or this machine itself. */
export interface Browser {
  readonly secure: boolean;
  readonly store: BrowserStorage;
  /** `sysex`: with system exclusive, as MIDI Show Control is. */
  readonly requestMidi: ((sysex: boolean) => Promise<MIDIAccess>) | null;
  readonly gamepads: (() => readonly (PadState | null)[]) | null;
  readonly hid: Hid | null;
  readonly now: () => number;
  readonly later: (call: () => void, milliseconds: number) => void;
}

/** Whether devices of a kind are heard here: `insecure` and `missing`: they cannot be, `denied`: the browser refused. */
export type DeviceHearing = "off" | "asking" | "on" | "denied" | "missing" | "insecure";

interface Here {
  readonly kind: DeviceKind;
  refused: string | null;
  /** Something that was sent to it did not reach it. */
  unsent?: boolean;
}

const KEY = "omote devices";

export class BrowserDevices {
  readonly hearing: Record<DeviceKind, DeviceHearing>;
  /** What is plugged in at this browser, and for each that the show does not take from here the reason. */
  readonly here = new Map<string, Here>();
  /** The browser lets MIDI Show Control through, where it lets MIDI. */
  showControl = true;
  readonly #midi: MidiPorts;
  readonly #pads: Gamepads;
  readonly #mice: SpaceMice | null;
  readonly #batches: ByteBatches;
  #online = false;
  #hidden = false;

  constructor(
    private readonly browser: Browser,
    private readonly store: Pick<ConsoleStore, "ask" | "tell">,
    private readonly send: (message: FromClient) => void,
  ) {
    const names = new DeviceNames(browser.store);
    const may = (api: unknown, safe: boolean): DeviceHearing =>
      safe && !browser.secure ? "insecure" : api === null ? "missing" : "off";
    this.hearing = {
      midi: may(browser.requestMidi, true),
      gamepad: may(browser.gamepads, false),
      space_mouse: may(browser.hid, true),
    };
    this.#batches = new ByteBatches(this.#sendBytes, browser.now, browser.later);
    this.#midi = new MidiPorts(names, this, (device, data) => this.#batches.add(device, data));
    this.#mice = browser.hid === null ? null : new SpaceMice(names, this, this.#moved, browser.hid);
    const passed = (pad: PadState): boolean =>
      this.#mice?.has(pad.id.replace(/.*Vendor: (\w{4}) Product: (\w{4}).*/i, "$1:$2")) ?? false;
    this.#pads = new Gamepads(names, this, this.#moved, browser.gamepads ?? (() => []), passed);
  }

  /** Hears again what was heard the last time; gamepads need no permission. */
  async start(): Promise<void> {
    const kept = readRecord(readKept(this.browser.store, KEY));
    if (kept.gamepad !== false && this.hearing.gamepad === "off") this.#set("gamepad", "on");
    if (kept.midi === true) await this.hear("midi", true);
    if (kept.space_mouse === true && this.hearing.space_mouse === "off" && ((await this.#mice?.open()) ?? 0) > 0)
      this.#set("space_mouse", "on");
  }

  /** Hears devices of a kind from now on, or no more; the browser may ask the operator. */
  async hear(kind: DeviceKind, on: boolean): Promise<void> {
    if (this.hearing[kind] === "missing" || this.hearing[kind] === "insecure") return;
    keep(this.browser.store, KEY, JSON.stringify({ ...readRecord(readKept(this.browser.store, KEY)), [kind]: on }));
    if (kind === "midi") await (on ? this.#openMidi() : this.#close("midi", () => this.#midi.close()));
    else if (kind === "space_mouse") await (on ? this.#openMice() : this.#close(kind, () => this.#mice?.close()));
    else if (on) this.#set("gamepad", "on");
    else this.#close("gamepad", () => this.#pads.close());
  }

  /** Looks at what tells of no change by itself: each frame. */
  look(): void {
    if (this.hearing.gamepad === "on" && !this.#hidden) this.#pads.look();
    this.#mice?.look();
  }

  /** The page is out of sight, where browsers freeze gamepads: what was held is let go, and another page can have them. */
  hide(hidden: boolean): void {
    if (hidden === this.#hidden) return;
    this.#hidden = hidden;
    if (hidden) this.#pads.close();
  }

  /** The link came up, where the show knows of none of our devices, or was lost. */
  setOnline(online: boolean): void {
    this.#online = online;
    if (online) for (const [device, { kind }] of this.here) this.#plug(device, kind);
  }

  /** What is plugged in anywhere: what another page had and has no more is taken from here. */
  receive(devices: readonly DeviceState[]): void {
    for (const [device, here] of this.here)
      if (here.refused !== null && !devices.some(({ name, plugged }) => name === device && plugged))
        this.#plug(device, here.kind);
  }

  /** The show sends something to a device; where a cue does and it does not arrive, the page says so. */
  receiveBytes(device: string, data: Uint8Array, cue = false): void {
    const here = this.here.get(device);
    const unsent = !this.#midi.send(device, data);
    if (!cue || here === undefined || unsent === (here.unsent ?? false)) return;
    here.unsent = unsent;
    this.store.tell("browser_devices");
  }

  plugged(device: string, kind: DeviceKind): void {
    this.here.set(device, { kind, refused: null });
    if (this.#online) this.#plug(device, kind);
    this.store.tell("browser_devices");
  }

  unplugged(device: string): void {
    this.#batches.forget(device);
    if (this.#heard(device)) this.send({ type: "unplug", device });
    this.here.delete(device);
    this.store.tell("browser_devices");
  }

  #plug(device: string, kind: DeviceKind): void {
    const here: Here = { kind, refused: null };
    this.here.set(device, here);
    const refused = ({ reason }: Refused): true => {
      here.refused = reason;
      this.store.tell("browser_devices");
      return true; // it stands beside the device
    };
    this.store.ask({ type: "plug", device, kind }, { refused });
    this.store.tell("browser_devices");
  }

  /** Whether the show hears a device from here. */
  #heard(device: string): boolean {
    return this.#online && this.here.get(device)?.refused === null;
  }

  readonly #sendBytes = (device: string, data: Uint8Array): void => {
    if (this.#heard(device)) this.send({ type: "midi_bytes", device, data });
  };

  readonly #moved = (device: string, values: Record<string, number>): void => {
    if (this.#heard(device)) this.send({ type: "controls", device, values });
  };

  async #openMidi(): Promise<void> {
    const { requestMidi } = this.browser;
    if (this.hearing.midi === "on" || requestMidi === null) return;
    this.#set("midi", "asking");
    try {
      const access = await requestMidi(true).catch(() => requestMidi(false));
      this.showControl = access.sysexEnabled !== false;
      this.#midi.open(access);
      this.#set("midi", "on");
    } catch {
      this.#set("midi", "denied");
    }
  }

  async #openMice(): Promise<void> {
    this.#set("space_mouse", "asking");
    try {
      const count = (await this.#mice?.ask()) ?? 0;
      this.#set("space_mouse", count > 0 ? "on" : "off");
    } catch {
      this.#set("space_mouse", "denied");
    }
  }

  #close(kind: DeviceKind, close: () => void): void {
    close();
    this.#set(kind, "off");
  }

  #set(kind: DeviceKind, hearing: DeviceHearing): void {
    this.hearing[kind] = hearing;
    this.store.tell("browser_devices");
  }
}

/** This browser. */
export function thisBrowser(): Browser {
  const { hid } = navigator as Navigator & { hid?: Hid };
  const midi = isSecureContext && "requestMIDIAccess" in navigator;
  return {
    secure: isSecureContext,
    store: () => localStorage,
    requestMidi: midi ? (sysex) => navigator.requestMIDIAccess({ sysex }) : null,
    gamepads: "getGamepads" in navigator ? () => navigator.getGamepads() : null,
    hid: hid ?? null,
    now: () => performance.now(),
    later: (call, milliseconds) => setTimeout(call, milliseconds),
  };
}
