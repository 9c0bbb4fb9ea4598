import { expect, it } from "vitest";
import type { DeviceState, FromClient } from "../../link/messages";
import { type Browser, BrowserDevices } from "./browser_devices";
import type { PadState } from "./gamepads";

type Host = ConstructorParameters<typeof BrowserDevices>[1];

/** A MIDI access with one input, as much of it as is used. */
function access(name = "Dial") {
  const input = { id: "1", name, state: "connected", onmidimessage: null as null | ((event: object) => void) };
  const midiAccess = { inputs: new Map([["1", input]]), outputs: new Map(), onstatechange: null };
  return { input, midiAccess: midiAccess as unknown as MIDIAccess };
}

function devices(change: Partial<Browser> = {}) {
  const sent: FromClient[] = [];
  const kept = new Map<string, string>();
  const pads: (PadState | null)[] = [];
  const browser: Browser = {
    secure: true,
    store: () => ({ getItem: (key) => kept.get(key) ?? null, setItem: (key, text) => void kept.set(key, text) }),
    requestMidi: async () => access().midiAccess,
    gamepads: () => pads,
    hid: null,
    now: () => 0,
    later: (call) => call(),
    ...change,
  };
  const refusals: ((reason: string) => unknown)[] = [];
  const store: Host = {
    ask: (asked, answers) => {
      sent.push(asked as FromClient);
      refusals.push((reason) => answers?.refused?.({ type: "refused", reason, id: "", held: [] }));
      return true;
    },
    tell: () => undefined,
  };
  const send = (message: FromClient): unknown => sent.push(message);
  return { browserDevices: new BrowserDevices(browser, store, send), sent, kept, pads, browser, store, refusals };
}

const state = (name: string, plugged: boolean): DeviceState => ({
  name,
  kind: "midi",
  where: "Left",
  plugged,
  rate: 0,
  heard: 0,
  rejected: 0,
  values: {},
  waiting: {},
  bank: "",
  banks: [],
  preset: "",
  advice: "",
});

it("asks for MIDI with Show Control, and without it where the browser keeps that back", async () => {
  const asked: boolean[] = [];
  const { browserDevices, browser } = devices();
  const requestMidi = async (sysex: boolean): Promise<MIDIAccess> => {
    asked.push(sysex);
    if (sysex) throw new Error("not allowed");
    return { ...(await browser.requestMidi?.(false)), sysexEnabled: false } as MIDIAccess;
  };
  const careful = devices({ requestMidi }).browserDevices;
  await careful.hear("midi", true);
  await browserDevices.hear("midi", true);
  expect(asked).toEqual([true, false]);
  expect([careful.hearing.midi, careful.showControl, browserDevices.showControl]).toEqual(["on", false, true]);
});

it("shows that what a cue sends to a device does not reach it", async () => {
  const { browserDevices } = devices();
  await browserDevices.hear("midi", true);
  browserDevices.receiveBytes("Dial", Uint8Array.of(0xb0, 7, 1)); // a lamp that it has not
  expect(browserDevices.here.get("Dial")?.unsent).toBeUndefined();
  browserDevices.receiveBytes("Dial", Uint8Array.of(0xf0, 0x7f, 0xf7), true);
  expect(browserDevices.here.get("Dial")?.unsent).toBe(true);
});

it("asks for MIDI when somebody wants it, and by itself the next time", async () => {
  const { browserDevices, kept, browser, store } = devices();
  await browserDevices.start();
  expect(browserDevices.hearing).toEqual({ midi: "off", gamepad: "on", space_mouse: "missing" });
  await browserDevices.hear("midi", true);
  expect([browserDevices.hearing.midi, [...browserDevices.here.keys()]]).toEqual(["on", ["Dial"]]);
  const next = new BrowserDevices(browser, store, () => undefined);
  await next.start();
  expect(next.hearing.midi).toBe("on");
  await next.hear("midi", false);
  expect([next.hearing.midi, next.here.size, kept.get("omote devices")]).toEqual(["off", 0, '{"midi":false}']);
});

it("says why there is no MIDI: refused, not there, not on a secure page", async () => {
  const refused = devices({ requestMidi: () => Promise.reject(new Error("no")) });
  await refused.browserDevices.hear("midi", true);
  const plain = devices({ secure: false, requestMidi: null });
  await plain.browserDevices.hear("midi", true);
  expect([
    refused.browserDevices.hearing.midi,
    plain.browserDevices.hearing.midi,
    plain.browserDevices.hearing.space_mouse,
  ]).toEqual(["denied", "insecure", "insecure"]);
  expect(devices({ requestMidi: null }).browserDevices.hearing.midi).toBe("missing");
  expect(devices({ gamepads: null }).browserDevices.hearing.gamepad).toBe("missing");
});

it("tells the show of each device when the link comes up, and sends nothing while it is lost", async () => {
  const { midiAccess, input } = access();
  const { browserDevices, sent } = devices({ requestMidi: async () => midiAccess });
  await browserDevices.hear("midi", true);
  input.onmidimessage?.({ data: Uint8Array.of(0xb0, 7, 1) });
  expect(sent).toEqual([]);
  browserDevices.setOnline(true);
  input.onmidimessage?.({ data: Uint8Array.of(0xb0, 7, 2) });
  browserDevices.setOnline(false);
  input.onmidimessage?.({ data: Uint8Array.of(0xb0, 7, 3) });
  browserDevices.setOnline(true);
  expect(sent.map(({ type }) => type)).toEqual(["plug", "midi_bytes", "plug"]);
  expect(sent[1]).toEqual({ type: "midi_bytes", device: "Dial", data: Uint8Array.of(0xb0, 7, 2) });
});

it("keeps still about a device that another page has, and takes it once that has it no more", async () => {
  const { midiAccess, input } = access();
  const { browserDevices, sent, refusals } = devices({ requestMidi: async () => midiAccess });
  browserDevices.setOnline(true);
  await browserDevices.hear("midi", true);
  expect(refusals[0]?.("Left has it.")).toBe(true); // nothing more is said
  input.onmidimessage?.({ data: Uint8Array.of(0xb0, 7, 2) });
  browserDevices.receive([state("Dial", true)]);
  expect([sent.length, browserDevices.here.get("Dial")?.refused]).toEqual([1, "Left has it."]);
  browserDevices.receive([state("Dial", false)]);
  input.onmidimessage?.({ data: Uint8Array.of(0xb0, 7, 3) });
  expect(sent.slice(1).map(({ type }) => type)).toEqual(["plug", "midi_bytes"]);
});

it("lets go of gamepads while the page is out of sight", async () => {
  const { browserDevices, sent, pads } = devices();
  await browserDevices.start();
  browserDevices.setOnline(true);
  const buttons = [{ value: 0, pressed: false }];
  pads[0] = { id: "Pad", index: 0, connected: true, mapping: "", axes: [], buttons };
  browserDevices.look();
  buttons[0] = { value: 1, pressed: true };
  browserDevices.look();
  browserDevices.hide(true);
  browserDevices.look();
  browserDevices.hide(false);
  browserDevices.look();
  expect(sent.map(({ type }) => type)).toEqual(["plug", "controls", "unplug", "plug"]);
});
