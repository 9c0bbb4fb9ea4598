import { expect, test } from "vitest";
import { sourceAddress, sourceLabel } from "./source_label";

test("a source is called by its app and its device, its address is a detail", () => {
  for (const address of ["192.168.0.12", "fe80::1c2:3%en0", "2001:db8::7", "2001:db8:0:0:0:0:2:1"]) {
    expect(sourceLabel(`Live Link Face Maria's iPhone ${address}`)).toBe("Live Link Face Maria's iPhone");
    expect(sourceAddress(`Live Link Face Maria's iPhone ${address}`)).toBe(address);
  }
});

test("what has no address is called as it is, also where it ends in a number", () => {
  for (const name of ["Camera Ada", "robot playback 1.5", "OpenSeeFace face 2", "192.168.0.12", "take 12:30:15"]) {
    expect(sourceLabel(name)).toBe(name);
    expect(sourceAddress(name)).toBe("");
  }
});

test("two that would read the same are told apart by their addresses", () => {
  const names = ["VMC 10.0.0.7", "VMC 10.0.0.8", "OpenSeeFace 10.0.0.7"];
  expect(names.map((name) => sourceLabel(name, names))).toEqual(["VMC 10.0.0.7", "VMC 10.0.0.8", "OpenSeeFace"]);
});
