/** MIDI devices at this browser (Web MIDI): they come, send, are sent what their lamps and motors show, and go. */

import type { Plug } from "../../link/messages";
import type { DeviceNames } from "./device_names";

export type DeviceKind = Plug["kind"];

/** What happens to the devices of a browser. */
export interface DeviceEvents {
  plugged(device: string, kind: DeviceKind): void;
  unplugged(device: string): void;
}

/** Ports that are no device: what is sent to them comes back, to everybody. */
const LOOPS = /^midi through/i;

export class MidiPorts {
  #access: MIDIAccess | null = null;
  /** The names of those that are here, by the browser's id of the port. */
  readonly #inputs = new Map<string, string>();

  constructor(
    private readonly names: DeviceNames,
    private readonly events: DeviceEvents,
    private readonly heard: (device: string, data: Uint8Array) => void,
  ) {}

  /** Plays all ports from now on, and each that comes. */
  open(access: MIDIAccess): void {
    this.#access = access;
    access.onstatechange = () => this.#look();
    this.#look();
  }

  /** Lets go of all ports. */
  close(): void {
    if (this.#access !== null) this.#access.onstatechange = null;
    for (const id of [...this.#inputs.keys()]) this.#leave(id);
    this.#access = null;
  }

  /** Sends bytes to the output of the same name; whether there was one that took them. */
  send(device: string, data: Uint8Array): boolean {
    const output = this.#outputOf(device);
    if (output === undefined) return false;
    try {
      output.send(data as Uint8Array<ArrayBuffer>);
      return true;
    } catch {
      return false; // another program has the port, or it is being pulled out
    }
  }

  #look(): void {
    const access = this.#access;
    if (access === null) return;
    for (const id of [...this.#inputs.keys()]) if (access.inputs.get(id)?.state !== "connected") this.#leave(id);
    for (const input of access.inputs.values()) if (input.state === "connected") this.#take(input);
  }

  #take(input: MIDIInput): void {
    const called = input.name ?? "";
    if (this.#inputs.has(input.id) || LOOPS.test(called)) return;
    const device = this.names.take(keyOf(input.id), called);
    this.#inputs.set(input.id, device); // before it is opened, which the browser tells as another change
    this.events.plugged(device, "midi");
    input.onmidimessage = ({ data }) => {
      if (data !== null && this.#inputs.has(input.id)) this.heard(device, data);
    };
  }

  #leave(id: string): void {
    const device = this.#inputs.get(id) as string;
    const input = this.#access?.inputs.get(id);
    if (input) input.onmidimessage = null;
    this.#inputs.delete(id);
    this.names.leave(keyOf(id));
    this.events.unplugged(device);
  }

  /** The output of a device: of two of a kind that in the same place among its kind. */
  #outputOf(device: string): MIDIOutput | undefined {
    const access = this.#access;
    const id = [...this.#inputs].find(([, name]) => name === device)?.[0];
    const input = id === undefined ? undefined : access?.inputs.get(id);
    if (access === null || input === undefined) return undefined;
    const alike = (ports: Iterable<MIDIPort>): MIDIPort[] =>
      [...ports].filter((port) => port.state === "connected" && baseName(port) === baseName(input));
    const place = alike(access.inputs.values()).findIndex((port) => port.id === input.id);
    return alike(access.outputs.values())[place] as MIDIOutput | undefined;
  }
}

const keyOf = (id: string): string => `midi ${id}`;

/** A port's name without what tells its two directions apart. */
const baseName = ({ name }: MIDIPort): string =>
  (name ?? "")
    .toLowerCase()
    .replace(/\b(midi )?(in|input|out|output)\b/g, "")
    .replace(/[^a-z0-9]+/g, " ")
    .trim();
