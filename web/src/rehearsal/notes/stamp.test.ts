import { expect, it } from "vitest";
import { Stamp } from "./stamp";

it("is of the first letter, until the field is empty", () => {
  let now = 1000;
  const stamp = new Stamp(() => now);
  expect(stamp.seconds()).toBeUndefined();
  stamp.type("t");
  now = 4000;
  stamp.type("too late");
  expect(stamp.seconds()).toBe(3);
  stamp.type(" ");
  stamp.type("x");
  expect(stamp.seconds()).toBe(0);
  stamp.begin(2);
  expect(stamp.seconds()).toBe(2);
  now += 1e8;
  expect(stamp.seconds()).toBe(3600);
});
