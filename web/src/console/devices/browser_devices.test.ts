import { expect, it } from "vitest";
import type { DeviceState, FromClient } from "../../link/messages";
import { type Browser, BrowserDevices } from "./browser_devices";
import type { PadState } from "./gamepads";

/** A MIDI access with one input, as much of it as is used. */
function access(name = "Dial") {
  const input = { id: "1", name, state: "connected", onmidimessage: null as null | ((event: object) => void) };
  const found = { inputs: new Map([["1", input]]), outputs: new Map(), onstatechange: null };
  return { input, found: found as unknown as MIDIAccess };
}

function devices(change: Partial<Browser> = {}) {
  const sent: FromClient[] = [];
  const kept = new Map<string, string>();
  const pads: (PadState | null)[] = [];
  const browser: Browser = {
    secure: true,
    store: () => ({ getItem: (key) => kept.get(key) ?? null, setItem: (key, text) => void kept.set(key, text) }),
    requestMidi: async () => access().found,
    gamepads: () => pads,
    hid: null,
    now: () => 0,
    later: (call) => call(),
    ...change,
  };
  return { made: new BrowserDevices(browser, (message) => sent.push(message), "page"), sent, kept, pads, browser };
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

it("asks for MIDI when somebody wants it, and by itself the next time", async () => {
  const { made, kept, browser } = devices();
  await made.start();
  expect(made.hearing).toEqual({ midi: "off", gamepad: "on", space_mouse: "missing" });
  await made.hear("midi", true);
  expect([made.hearing.midi, [...made.here.keys()]]).toEqual(["on", ["Dial"]]);
  const next = new BrowserDevices(browser, () => undefined, "next");
  await next.start();
  expect(next.hearing.midi).toBe("on");
  await next.hear("midi", false);
  expect([next.hearing.midi, next.here.size, kept.get("omote devices")]).toEqual(["off", 0, '{"midi":false}']);
});

it("says why there is no MIDI: refused, not there, not on a secure page", async () => {
  const refused = devices({ requestMidi: () => Promise.reject(new Error("no")) });
  await refused.made.hear("midi", true);
  const plain = devices({ secure: false, requestMidi: null });
  await plain.made.hear("midi", true);
  expect([refused.made.hearing.midi, plain.made.hearing.midi, plain.made.hearing.space_mouse]).toEqual([
    "denied",
    "insecure",
    "insecure",
  ]);
  expect(devices({ requestMidi: null }).made.hearing.midi).toBe("missing");
  expect(devices({ gamepads: null }).made.hearing.gamepad).toBe("missing");
});

it("tells the show of each device when the link comes up, and sends nothing while it is lost", async () => {
  const { found, input } = access();
  const { made, sent } = devices({ requestMidi: async () => found });
  await made.hear("midi", true);
  input.onmidimessage?.({ data: Uint8Array.of(0xb0, 7, 1) });
  expect(sent).toEqual([]);
  made.setOnline(true);
  input.onmidimessage?.({ data: Uint8Array.of(0xb0, 7, 2) });
  made.setOnline(false);
  input.onmidimessage?.({ data: Uint8Array.of(0xb0, 7, 3) });
  made.setOnline(true);
  expect(sent.map(({ type }) => type)).toEqual(["plug", "midi_bytes", "plug"]);
  expect(sent[1]).toEqual({ type: "midi_bytes", device: "Dial", data: Uint8Array.of(0xb0, 7, 2) });
});

it("keeps still about a device that another page has, and takes it once that has it no more", async () => {
  const { found, input } = access();
  const { made, sent } = devices({ requestMidi: async () => found });
  made.setOnline(true);
  await made.hear("midi", true);
  const plug = sent[0] as Extract<FromClient, { type: "plug" }>;
  expect(made.receiveRefused("Left has it.", "other")).toBe(false);
  expect(made.receiveRefused("Left has it.", plug.id)).toBe(true);
  input.onmidimessage?.({ data: Uint8Array.of(0xb0, 7, 2) });
  made.receive([state("Dial", true)]);
  expect([sent.length, made.here.get("Dial")?.refused]).toEqual([1, "Left has it."]);
  made.receive([state("Dial", false)]);
  input.onmidimessage?.({ data: Uint8Array.of(0xb0, 7, 3) });
  expect(sent.slice(1).map(({ type }) => type)).toEqual(["plug", "midi_bytes"]);
});

it("lets go of gamepads while the page is out of sight", async () => {
  const { made, sent, pads } = devices();
  await made.start();
  made.setOnline(true);
  const buttons = [{ value: 0, pressed: false }];
  pads[0] = { id: "Pad", index: 0, connected: true, mapping: "", axes: [], buttons };
  made.look();
  buttons[0] = { value: 1, pressed: true };
  made.look();
  made.hide(true);
  made.look();
  made.hide(false);
  made.look();
  expect(sent.map(({ type }) => type)).toEqual(["plug", "controls", "unplug", "plug"]);
});
