import { expect, it } from "vitest";
import { DeviceNames } from "./device_names";
import { Gamepads, type PadState } from "./gamepads";

const XBOX = "Xbox Wireless Controller (STANDARD GAMEPAD Vendor: 045e Product: 0b13)";

function pad(id: string, index: number, axes: number[] = [0, 0, 0, 0]) {
  const buttons = Array.from({ length: 17 }, () => ({ value: 0, pressed: false }));
  return { id, index, connected: true, mapping: "standard", axes, buttons };
}

function gamepads(passed?: (pad: PadState) => boolean) {
  const listed: (PadState | null)[] = [null, null, null, null];
  const news: string[] = [];
  const moved: [string, Record<string, number>][] = [];
  const names = new DeviceNames(() => ({ getItem: () => null, setItem: () => undefined }));
  const gamepadReader = new Gamepads(
    names,
    { plugged: (device, kind) => news.push(`+${device} ${kind}`), unplugged: (device) => news.push(`-${device}`) },
    (device, values) => moved.push([device, values]),
    () => listed,
    passed,
  );
  return { gamepadReader, listed, news, moved };
}

it("plays nothing by coming, and then what has moved alone", () => {
  const { gamepadReader, listed, moved, news } = gamepads();
  const one = pad(XBOX, 0, [0.1, 0, 0, -1]);
  listed[0] = one;
  gamepadReader.look();
  gamepadReader.look();
  expect([news, moved]).toEqual([["+Xbox Wireless Controller (045e:0b13) gamepad"], []]);
  one.axes[0] = 1;
  one.buttons[0] = { value: 1, pressed: true };
  gamepadReader.look();
  gamepadReader.look();
  expect(moved).toEqual([["Xbox Wireless Controller (045e:0b13)", { axis0: 1, button0: 1 }]]);
});

it("gives a trigger as a key and as a level, and every value from 0 to 1", () => {
  const { gamepadReader, listed, moved } = gamepads();
  const one = pad(XBOX, 0);
  listed[0] = one;
  gamepadReader.look();
  one.buttons[7] = { value: 0.25, pressed: false };
  one.axes.splice(0, 3, 1.00001, -1.2, Number.NaN);
  gamepadReader.look();
  expect(moved[0]?.[1]).toEqual({ axis0: 1, axis1: 0, button7: 0.25, trigger7: 0.25 });
});

it("lets go of a pad that is gone, that another takes the place of, and of all", () => {
  const { gamepadReader, listed, news } = gamepads();
  listed[0] = pad("a", 0);
  listed[1] = pad("a", 1);
  gamepadReader.look();
  listed[0] = pad("b", 0);
  gamepadReader.look();
  gamepadReader.close();
  expect(news).toEqual(["+a gamepad", "+a 2 gamepad", "-a", "+b gamepad", "-a 2", "-b"]);
});

it("knows a space mouse by its name and its six axes, and passes over one that is read elsewhere", () => {
  const { gamepadReader, listed, news, moved } = gamepads(({ id }) => id.includes("c635"));
  const mouse = pad("SpaceMouse Compact (Vendor: 256f Product: c652)", 0, [0, 0, 0, 0, 0, 0]);
  listed[0] = mouse;
  listed[1] = pad("SpaceMouse Compact (Vendor: 256f Product: c635)", 1, [0, 0, 0, 0, 0, 0]);
  gamepadReader.look();
  mouse.axes[5] = -1;
  gamepadReader.look();
  expect(news).toEqual(["+SpaceMouse Compact (256f:c652) space_mouse"]);
  expect(moved).toEqual([["SpaceMouse Compact (256f:c652)", { rz: 0 }]]);
});
