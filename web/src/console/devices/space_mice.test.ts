import { expect, it } from "vitest";
import { DeviceNames } from "./device_names";
import { type Hid, type HidDevice, readReport, SpaceMice } from "./space_mice";

const bytes = (...values: number[]) => {
  const data = new DataView(new ArrayBuffer(values.length * 2));
  for (const [index, value] of values.entries()) data.setInt16(2 * index, value, true);
  return data;
};

it("reads axes from end to end with their rest in the middle, in both forms of report", () => {
  expect(readReport({ reportId: 1, data: bytes(-350, 0, 350) })).toEqual({ x: 0, y: 0.5, z: 1 });
  expect(readReport({ reportId: 2, data: bytes(0, 175, -500) })).toEqual({ rx: 0.5, ry: 0.75, rz: 0 });
  expect(Object.keys(readReport({ reportId: 1, data: bytes(0, 0, 0, 0, 0, 0) }))).toEqual([
    "x",
    "y",
    "z",
    "rx",
    "ry",
    "rz",
  ]);
  expect(readReport({ reportId: 23, data: bytes(1) })).toEqual({});
  expect(readReport({ reportId: 1, data: new DataView(new ArrayBuffer(1)) })).toEqual({});
});

it("reads buttons as keys", () => {
  const buttons = readReport({ reportId: 3, data: new DataView(Uint8Array.of(0b10).buffer) });
  expect([buttons.button0, buttons.button1, Object.keys(buttons).length]).toEqual([0, 1, 8]);
});

class Mouse extends EventTarget implements HidDevice {
  opened = false;
  readonly productName = "SpaceNavigator";
  readonly vendorId = 0x046d;
  readonly productId = 0xc626;

  async open(): Promise<void> {
    this.opened = true;
  }

  async close(): Promise<void> {
    this.opened = false;
  }

  report(reportId: number, data: DataView): void {
    this.dispatchEvent(Object.assign(new Event("inputreport"), { reportId, data }));
  }
}

class Usb extends EventTarget implements Hid {
  granted: Mouse[] = [];

  async getDevices(): Promise<HidDevice[]> {
    return this.granted;
  }

  async requestDevice(): Promise<HidDevice[]> {
    this.granted = [new Mouse()];
    return this.granted;
  }
}

it("hears what was chosen, tells moves once a look and presses at once, and lets go of it", async () => {
  const usb = new Usb();
  const news: string[] = [];
  const moved: Record<string, number>[] = [];
  const names = new DeviceNames(() => ({ getItem: () => null, setItem: () => undefined }));
  const events = {
    plugged: (device: string) => news.push(`+${device}`),
    unplugged: (device: string) => news.push(`-${device}`),
  };
  const mice = new SpaceMice(names, events, (_, values) => moved.push(values), usb);
  expect([await mice.open(), await mice.ask(), mice.has("046d:c626")]).toEqual([0, 1, true]);
  const [mouse] = usb.granted as [Mouse];
  mouse.report(1, bytes(350, 0, 0));
  mouse.report(1, bytes(175, 0, 0));
  mice.look();
  mouse.report(3, new DataView(Uint8Array.of(1).buffer));
  mouse.report(3, new DataView(Uint8Array.of(0).buffer));
  expect(moved).toEqual([{ x: 0.75 }, { button0: 1 }, { button0: 0 }]);
  usb.dispatchEvent(Object.assign(new Event("disconnect"), { device: mouse }));
  mouse.report(1, bytes(0, 0, 0));
  mice.look();
  expect([news, moved.length]).toEqual([["+SpaceNavigator", "-SpaceNavigator"], 3]);
});
