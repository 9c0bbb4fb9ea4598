import { describe, expect, it } from "vitest";
import { DeviceNames, readableName } from "./device_names";

function memory(): { store: () => Pick<Storage, "getItem" | "setItem">; kept: Map<string, string> } {
  const kept = new Map<string, string>();
  return {
    kept,
    store: () => ({ getItem: (key) => kept.get(key) ?? null, setItem: (key, text) => void kept.set(key, text) }),
  };
}

describe("DeviceNames", () => {
  it("gives two of a kind two names, which stay with each through unplugging and a reload", () => {
    const { store } = memory();
    const names = new DeviceNames(store);
    expect([names.take("a", "X-Touch Mini"), names.take("b", "X-Touch Mini")]).toEqual([
      "X-Touch Mini",
      "X-Touch Mini 2",
    ]);
    names.leave("a");
    names.leave("b");
    expect(names.take("b", "X-Touch Mini")).toBe("X-Touch Mini 2");
    expect(new DeviceNames(store).take("b", "X-Touch Mini")).toBe("X-Touch Mini 2");
  });

  it("gives a device that the browser calls anew its name again, unless that is taken", () => {
    const names = new DeviceNames(memory().store);
    names.take("a", "Dial");
    names.leave("a");
    expect(names.take("c", "Dial")).toBe("Dial");
    expect(names.take("a", "Dial")).toBe("Dial 2");
  });

  it("plays where nothing can be stored, and where something else is", () => {
    const forbidden = () => {
      throw new Error("forbidden");
    };
    expect(new DeviceNames(forbidden).take("a", "Dial")).toBe("Dial");
    const { store, kept } = memory();
    kept.set("omote device names", "[1]");
    expect(new DeviceNames(store).take("a", "Dial")).toBe("Dial");
    kept.set("omote device names", '{"a": 7}');
    expect(new DeviceNames(store).take("a", "Dial")).toBe("Dial");
  });

  it("keeps every name within what the wire takes", () => {
    const names = new DeviceNames(memory().store);
    const long = "x".repeat(200);
    const all = ["a", "b", "c"].map((id) => names.take(id, long));
    expect(all.every((name) => name.length === 80)).toBe(true);
    expect(new Set(all).size).toBe(3);
  });
});

it("reads the numbers of a gamepad the same from every browser", () => {
  expect(readableName("Xbox Wireless Controller (STANDARD GAMEPAD Vendor: 045e Product: 0b13)")).toBe(
    "Xbox Wireless Controller (045e:0b13)",
  );
  expect(readableName("045e-0b13-Xbox Wireless Controller")).toBe("Xbox Wireless Controller (045e:0b13)");
  expect(readableName("nanoKONTROL2 MIDI 1")).toBe("nanoKONTROL2 MIDI 1");
  expect(readableName("  ")).toBe("device without a name");
});
