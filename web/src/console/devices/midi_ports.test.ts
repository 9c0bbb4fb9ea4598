import { beforeEach, expect, it } from "vitest";
import WMT from "web-midi-test";
import { DeviceNames } from "./device_names";
import { MidiPorts } from "./midi_ports";

const heard: [string, number[]][] = [];
const news: string[] = [];
let ports: MidiPorts;
let count = 0;
/** All ports that a test has made. */
const openPorts: { disconnect(): void }[] = [];

beforeEach(async () => {
  for (const one of openPorts.splice(0)) one.disconnect();
  ports?.close();
  heard.length = 0;
  news.length = 0;
  const nothing = () => ({ getItem: () => null, setItem: () => undefined });
  ports = new MidiPorts(
    new DeviceNames(nothing),
    { plugged: (device, kind) => news.push(`+${device} ${kind}`), unplugged: (device) => news.push(`-${device}`) },
    (device, data) => heard.push([device, [...data]]),
  );
  ports.open((await WMT.requestMIDIAccess()) as unknown as MIDIAccess);
});

/** A device that no test before has; `plug` puts it in. */
function device(name = `device ${count++}`) {
  const [source, sink] = [new WMT.MidiSrc(name), new WMT.MidiDst(name)];
  openPorts.push(source, sink);
  const messages: number[][] = [];
  sink.receive = (message = []) => void messages.push([...message]);
  return { name, source, sink, told: messages };
}

it("hears a device that is plugged in, unplugged and plugged in again, under the same name", () => {
  const { name, source } = device();
  source.connect();
  source.emit([0xb0, 7, 64]);
  source.disconnect();
  source.connect();
  source.emit([0xb0, 7, 66]);
  expect(news).toEqual([`+${name} midi`, `-${name}`, `+${name} midi`]);
  expect(heard).toEqual([
    [name, [0xb0, 7, 64]],
    [name, [0xb0, 7, 66]],
  ]);
});

it("sends what a device shows to the output of its name alone, and to the right one of two of a kind", () => {
  const [one, other, third] = [device("twin"), device("twin"), device()];
  for (const { source, sink } of [one, other, third]) {
    source.connect();
    sink.connect();
  }
  expect(ports.send("twin 2", Uint8Array.of(0xb0, 7, 1, 0xb0, 8, 2))).toBe(true);
  expect([one.told, other.told, third.told]).toEqual([
    [],
    [
      [0xb0, 7, 1],
      [0xb0, 8, 2],
    ],
    [],
  ]);
});

it("says of an output that is not there, or is refused, that nothing was sent", () => {
  const { name, source, sink } = device();
  source.connect();
  expect(ports.send(name, Uint8Array.of(0xb0, 7, 1))).toBe(false);
  sink.connect();
  expect(ports.send(name, Uint8Array.of(7, 1))).toBe(false); // no status: the browser throws
  expect(ports.send("nobody", Uint8Array.of(0xb0, 7, 1))).toBe(false);
});

it("passes over ports that give back what is sent to them", () => {
  const { source } = device("Midi Through Port-0");
  source.connect();
  expect(news).toEqual([]);
});

it("lets go of all when it is closed", () => {
  const { name, source } = device();
  source.connect();
  ports.close();
  source.emit([0xb0, 7, 64]);
  expect([news.at(-1), heard]).toEqual([`-${name}`, []]);
});
